% STOREDSHAPE  What a form.csv would say of a storedStandIn, of runs beside its own.
%
% CALL: SHAPE = storedShape (S, WRONG [, RIGHT])
%
%   S      struct of storedStandIn
%   WRONG  '': as it is; 'other': each result has what is known of the next one, as
%          with the file of another bench; 'half': of every second parameter it has the
%          sign wrong
%   RIGHT  storedShape (S, ''), where it is at hand
%   SHAPE  1 x T cell of d x 2, see knownShapes
%
% Of drumAndBins and hiddenEffect the runs with an effect tell, which are none of the
% stand-in's: grains with cohesion, of other size, a tilted rig. The effect is a further
% input, and 0 in what is learnt. Of repose every second run tells; all of them make
% the stand-in.

function shape = storedShape (S, wrong, right)
  if nargin < 3
    right = rightShape (S);
  end
  shape = right;
  if strcmp (wrong, 'other')
    shape = right([2:end, 1]);
  elseif strcmp (wrong, 'half')
    shape = cellfun (@(C) C .* (-1).^(1:rows (C))', right, 'UniformOutput', false);
  end
end

function shape = rightShape (S)
  root = startBenchmarks ();
  if strcmp (S.name, 'repose')
    store = storedRepose (root);
    [problem, data] = deal (store.problem, keepRows (store.data, 2:2:121));
    phi = zeros (60, 0);
  else
    [given, data] = storedCampaign (S.name, root);
    problem = newProblem (given);
    phi = strengthOfValues (problem.effects, data.E);
    isOther = any (abs (phi) > 1e-9, 2);
    [data, phi] = deal (keepRows (data, isOther), phi(isOther, :));
  end
  [~, at] = ismember (S.targetNames, problem.targetNames);
  for t = 1:numel (at)
    shape{t} = shapeOfRuns (data.X, data.Z(:, at(t)), problem.limits, phi);
  end
end

%!test
%! S = storedStandIn ('repose', 1);
%! C = storedShape (S, '');
%! assert (cellfun (@size, C, 'UniformOutput', false), {[2, 2], [2, 2]});
%! other = storedShape (S, 'other', C);
%! assert (other{1}, C{2});
%! half = storedShape (S, 'half', C){1};
%! assert (half, C{1} .* [-1; 1]);

% SPDX-License-Identifier: GPL-3.0-only
