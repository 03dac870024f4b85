% RUNEACH  Runs every end of the range of every effect once.
%
% CALL: STATE = runEach (PROBLEM, STATE, THETA)
%
%   PROBLEM, STATE     of newProblem, newGapState
%   THETA              1 x p, in [-1, 1], where they are run
%
% An end that a run with all results of the models that are run has reached to more
% than half is not run again. One that gives none at full strength is run at a half, a
% quarter and an eighth, each once, wherever it was that it failed; but where more than
% half of all ends fail, the effects are not to blame.

function state = runEach (problem, state, theta)
  ends = endsOf (problem.effects);
  n = rows (ends);
  for share = [1, 0.5, 0.25, 0.125]
    phi = strengthOfValues (problem.effects, state.data.E);
    phi(sum (abs (phi) > 1e-9, 2) ~= 1, :) = 0;
    isAsked = askedResults (state.budget, problem.bench);
    isWhole = all (isfinite (state.data.Z(:, isAsked)), 2);
    least = 0.5 * (share == 1);
    isMissing = false (1, n);
    for i = 1:n
      % shares of this end, and of no other
      shares = (phi * ends(i, :)') / sumsq (ends(i, :));
      % within a factor of sqrt (2) it is the same strength
      isTried = abs (log2 (max (shares, 1e-9) / share)) < 0.5;
      isMissing(i) = ~any (shares(isWhole) > max (least, 1e-9)) && ~any (isTried);
    end
    missing = find (isMissing);
    % where most effects give no result, strength is not what is wrong
    if share < 1 && numel (missing) > max (n / 2, 1)
      return
    end
    batch = struct ('theta', repmat (theta, numel (missing), 1), ...
                    'phi', share * ends(missing, :), ...
                    'isFine', false (numel (missing), 1));
    state = runBatch (problem, state, batch);
  end
end

function ends = endsOf (effects)
  K = numel (effects);
  ends = zeros (0, K);
  for k = find (~[effects.laboratory])
    for limit = effects(k).range(effects(k).range ~= 0)
      ends(end + 1, :) = limit * ((1:K) == k);
    end
  end
end

%!test
%! % each end once; what jams above 0.4 at a half and a quarter, too, and none
%! % of that again from another set
%! [given, data, means] = smallGapLab ();
%! given.value = ones (1, 12);
%! problem = newProblem (given);
%! data = keepRows (data, all (data.E == 0, 2));
%! run = @(X, E, varargin) means (X, [E, zeros(rows (E), 1)]) + ...
%!                         0 ./ (E(:, 3) < 0.46);
%! options = gapOptions (struct ('maxNewRuns', 60));
%! state = newGapState (data, options, run);
%! state = runEach (problem, state, [0.1, 0.2]);
%! assert ([state.budget.new, state.budget.failed], [6, 2]);
%! again = runEach (problem, state, [0.2, 0.1]);
%! assert (again.budget.new, 6);
%! % one that never works is tried four times in all
%! never = @(X, E, varargin) means (X, [E, zeros(rows (E), 1)]) + ...
%!                           0 ./ ~E(:, 2);
%! state = newGapState (data, options, never);
%! state = runEach (problem, state, [0.1, 0.2]);
%! assert ([state.budget.new, state.budget.failed], [7, 4]);
%! assert (runEach (problem, state, [0.2, 0.1]).budget.new, 7);

% SPDX-License-Identifier: GPL-3.0-only
