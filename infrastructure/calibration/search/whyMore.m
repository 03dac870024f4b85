% WHYMORE  Why more runs are made: the result that is least sure to be met.
%
% CALL: TEXT = whyMore (STATE, PROBLEM, N)
%
%   N     runs that follow
%   TEXT  'infill: a run of force scatters by 1.1 times its tolerance: 6 more runs'

function text = whyMore (state, problem, n)
  p = state.found.params;
  [m, v] = predictSurrogate (state.surrogates, p);
  [~, slope] = targetResidual (problem, p, m);
  half = problem.tol ./ abs (slope(1, :));
  miss = abs (m - problem.value);
  noise = sqrt ([state.surrogates.noiseVar]);
  left = (half - miss) ./ sqrt (v + noise.^2);
  left(~problem.calibrate) = Inf;
  [~, t] = min (left);
  [code, off] = deal ('infill.unsure', sqrt (v(t)));
  if miss(t) > half(t)
    [code, off] = deal ('infill.miss', miss(t));
  elseif noise(t) > half(t)
    [code, off] = deal ('infill.scatter', noise(t));
  end
  text = sentence (code, struct ('name', problem.targetNames{t}, 'n', n, 'times', ...
                                 sprintf ('%.2g', off / half(t))));
end

%!test
%! [problem, state] = smallCalibration ();
%! text = whyMore (state, problem, 6);
%! assert (! isempty (strfind (text, '6 more runs')));
%! for k = 1:numel (state.surrogates)
%!   state.surrogates(k).noiseVar = 100;
%! end
%! problem.value = predictSurrogate (state.surrogates, state.found.params);
%! assert (! isempty (strfind (whyMore (state, problem, 6), 'scatters by ')));

% SPDX-License-Identifier: GPL-3.0-only
