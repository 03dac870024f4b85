% REPEATSUSPECTS  Runs once more what looks wrong, before it is left out.
%
% CALL: STATE = repeatSuspects (STATE, PROBLEM [, SAY])
%
%   STATE, PROBLEM  see newState, newProblem
%   SAY             gets a line about each set that is run once more
%
% A run that is off by far more than runs scatter may be wrong, or the only one
% that shows a peak, a jump or a second outcome. Its set is run once more, with
% another seed, where the budget allows it; findBadRuns judges with both. A set
% is run once more but once: where the second run fails, or is the same to the
% last digit, the first one counts.

function state = repeatSuspects (state, problem, say)
  if nargin < 3
    say = @(text) [];
  end
  while true
    rowsOf = find (openSuspects (state, problem));
    rowsOf = rowsOf(1:min (end, budgetLeft (state, problem)));
    if isempty (rowsOf)
      return
    end
    lines = suspectLines (state, problem, rowsOf);
    for line = lines
      say (['  ', line{1}, ': it is run once more']);
    end
    before = rows (state.data.X);
    state = addRuns (state, problem, state.data.X(rowsOf, :), ...
                     state.data.E(rowsOf, :), 'repeat');
    if rows (state.data.X) == before
      return                             % nothing can be run
    end
    state.surrogates = fitSurrogates (state.data, problem, state.surrogates);
  end
end

%!function [problem, state] = peakCase (second)
%!  % ten runs of a flat response with a peak that one run shows
%!  X = linspace (0, 1, 10)';
%!  f = @(x) 1 + 5 * exp (-((x - 1) / 0.03).^2);
%!  problem = smallProblem (4, 0.02);
%!  randn ('twister', 1);
%!  Z = f (X) + 0.02 * randn (10, 1);
%!  data = addRows (newData (1, 1), X, Z, ones (10, 1), 'plan');
%!  state = newState (data, fitSurrogates (data, problem), []);
%!  [state.evaluate, state.budget] = newEvaluate (@(P, E, r) second);
%!endfunction
%!test
%! % the second run is like the first one: both count
%! [problem, state] = peakCase (5.97);
%! assert (find (state.surrogates.suspect), 10);
%! assert (! any (state.surrogates.leftOut));
%! said = evalc ('state = repeatSuspects (state, problem, @disp);');
%! assert (regexp (said, 'the run at a = 1 gave .* it is run once more'));
%! assert ([state.data.X(end), state.data.replicate(end)], [1, 2]);
%! assert (! any ([state.surrogates.leftOut; state.surrogates.suspect]));
%!test
%! % it is like the others: the first one is left out
%! [problem, state] = peakCase (1.01);
%! state = repeatSuspects (state, problem);
%! assert (find (state.surrogates.leftOut), 10);
%! assert (state.surrogates.aside, state.data.Z(10));
%!test
%! % no run can be made, or it fails: the first one counts
%! for second = [NA, NaN]
%!   [problem, state] = peakCase (second);
%!   state = repeatSuspects (state, problem);
%!   assert (rows (state.data.X), 10 + ! isna (second));
%!   assert (! any (state.surrogates.leftOut));
%! end

% SPDX-License-Identifier: GPL-3.0-only
