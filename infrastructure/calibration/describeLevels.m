% DESCRIBELEVELS  What each level has told and cost, at the found set.
%
% CALL: LEVELS = describeLevels (STATE, PROBLEM)
%
%   STATE    struct of newState, with its field final
%   PROBLEM  struct of newProblem
%   LEVELS   1 x L struct array, empty where PROBLEM.coarse is: value (1 x v, of
%            the level variables), runs (rows of the data there), seconds (of a
%            run; NaN: not known), shift and shiftSd (1 x T: response at this
%            level less that at the last one, at the set, and how well it is
%            known; 0 for a model without levels), noiseSd (1 x T, of a run),
%            dropped (1 x T logical: the surrogate does not hold its runs; the
%            others are NaN then)

function levels = describeLevels (state, problem)
  levels = struct ('value', {}, 'runs', {}, 'seconds', {}, 'shift', {}, ...
                   'shiftSd', {}, 'noiseSd', {}, 'dropped', {});
  if isempty (problem.coarse)
    return
  end
  seconds = levelSeconds (state, problem);
  for k = 1:rows (problem.coarse.levels)
    own = struct ('value', problem.coarse.levels(k, :), 'runs', 0, ...
                  'seconds', NaN);
    own.runs = sum (all (state.data.E == own.value, 2));
    if ~isempty (seconds)
      own.seconds = seconds(k);
    end
    for t = 1:numel (state.surrogates)
      s = state.surrogates(t);
      level = unitLevel (problem.coarse, own.value, t);
      own.dropped(t) = any (s.dropped == level);
      [own.shift(t), own.shiftSd(t), own.noiseSd(t)] = ...
        levelShift (s, state.final.params, level);
    end
    levels(k) = own;
  end
end

%!test
%! pkg load stk
%! rand ('twister', 4);
%! randn ('twister', 4);
%! C = struct ('names', {{'a', 'b'}}, 'limits', [0, 0; 1, 1]);
%! C.targets = struct ('value', {2, 1}, 'tol', 0.01, 'model', {1, 2});
%! C.coarse = struct ('variable', 'scaleP', 'levels', [2, 1], 'models', 1);
%! problem = newProblem (C, []);
%! X = rand (16, 2);
%! E = [2 * ones(8, 1); ones(8, 1)];
%! Z = [sum(X, 2) + 0.3 * (E - 1), X(:, 1)] + 0.005 * randn (16, 2);
%! data = addRows (newData (2, 2, 1), X, Z, ones (16, 1), 'plan', E);
%! state = newState (data, fitSurrogates (data, problem), []);
%! state.final = struct ('params', [0.4, 0.6]);
%! levels = describeLevels (state, problem);
%! assert ([levels.value; levels.runs], [2, 1; 8, 8]);
%! assert (levels(1).shift, [0.3, 0], 0.02);
%! assert (levels(1).shiftSd(1) < 0.02);
%! assert (levels(2).shift, [0, 0]);
%! state.surrogates(1).dropped = 1;
%! levels = describeLevels (state, problem);
%! assert (isnan (levels(1).shift), [true, false]);
%! problem.coarse = [];
%! assert (isempty (describeLevels (state, problem)));
