% FORESEESETS  How many parameter sets a diagnosis will ask for at most.
%
% CALL: [SETS, LINES] = foreseeSets (EFFECTS, LEFT, OPTIONS [, SECONDS])
%
%   EFFECTS  1 x K struct of newProblem;  LEFT  scalar, sets that may be run,
%            each of them a run of every model
%   OPTIONS  of gapOptions
%   SECONDS  scalar, core time of one set so far (NaN: not known)
%   SETS     scalar, no more than LEFT
%   LINES    cellstr, what is foreseen, and what LEFT leaves out
%
% Foreseen at most: each effect once, twice where it acts both ways; 6 batches
% of 5; 5 seeds of each of four compared sets; 12 to mend surrogates or to seek
% a gap. The runs end as soon as the answer stands (exploreEffects), and without
% a gap after the first ones and those that sought it. Where Input.maxNewRuns
% allows less, a third of it is kept to verify; effects for which nothing is
% left are the last of the list, and are named.

function [sets, lines] = foreseeSets (effects, left, options, seconds)
  if nargin < 4
    seconds = NaN;
  end
  names = {};
  ends = zeros (1, 0);
  for effect = reshape (effects, 1, [])
    if ~effect.laboratory
      names{end + 1} = effect.name;
      ends(end + 1) = 1 + (effect.range(1) < 0);
    end
  end
  share = [12, sum(ends), options.batches * options.batch * ~isempty(ends), ...
           4 * options.verifyRuns];
  wanted = sum (share);
  sets = max (min (left, wanted), 0);
  lines = {sprintf(['at most %d choices of parameter values are run with all models: ' ...
                    '%d to know the model better, %d for %d causes, %d to tell the ' ...
                    'likeliest apart, %d to prove it; %d to %d where nothing is missing'], ...
                   wanted, share(1:2), numel (names), share(3:4), ...
                   share(2) + [0, options.seekRuns])};
  if isfinite (seconds)
    lines{end + 1} = sprintf ('they take at most %s of one CPU', inWords (sets * seconds));
  end
  if left < wanted
    lines{end + 1} = sprintf ('Input.maxNewRuns allows %d of them', ...
                              max (left, 0));
    % what verifies the cure is set aside first (exploreEffects)
    first = left - min (share(4), floor (left / 3));
    missing = names(cumsum (ends) > first);
    if ~isempty (missing) && left > 0
      lines{end + 1} = ['without runs, unless there are some already: ', ...
                        strjoin(missing, ', ')];
    end
  end
end

%!shared effect, options
%! effect = newEffect (struct ('name', 'e', 'variables', {{'e'}}, ...
%!                             'neutral', 0, 'limits', [0; 1]), 1);
%! options = gapOptions ([]);
%!test
%! % 10, 20 and 40 effects; the third one acts both ways
%! sets = [];
%! for K = [10, 20, 40]
%!   effects = repmat (effect, 1, K);
%!   effects(3).range = [-1, 1];
%!   sets(end + 1) = foreseeSets (effects, 1500, options);
%! end
%! assert (sets, 12 + [11, 21, 41] + 30 + 20);
%!test
%! % what is left out is said
%! effects = repmat (effect, 1, 10);
%! effects(10).name = 'last';
%! [sets, lines] = foreseeSets (effects, 13, options, 30);
%! assert (sets, 13);
%! assert (~isempty (strfind (lines{2}, '6 min of one CPU')));
%! assert (~isempty (strfind (lines{end}, 'already: last')));

% SPDX-License-Identifier: GPL-3.0-only
