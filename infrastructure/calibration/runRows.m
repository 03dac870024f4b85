% RUNROWS  Makes DEM runs, adds them to the data and refits the surrogates.
%
% CALL: STATE = runRows (STATE, PROBLEM, EVALUATE, P, STAGE)
%
% P         n x d  sets; a set that stands in the data already (or twice in P)
%           gets the next replicate number, so another packing
% EVALUATE  handle Z = evaluate (P, replicate), n x T, NaN = failed; a row with
%           NA was not run (no budget) and leaves no trace
% STAGE     'infill', 'verify' or 'replicate'
%
% Never more rows than the budget has: what is over is left out.
%
% See also: budgetLeft, improveByInfill, calibrateOnDEM

function state = runRows (state, problem, evaluate, P, stage)
  P = P(1:min (rows (P), budgetLeft (state, problem)), :);
  if isempty (P)
    return
  end
  replicate = ones (rows (P), 1);
  for i = 1:rows (P)
    earlier = [state.data.X; P(1:i - 1, :)];
    numbers = [state.data.replicate; replicate(1:i - 1)];
    same = sameSet (earlier, P(i, :), problem.limits);
    replicate(i) = max ([0; numbers(same)]) + 1;
  end
  Z = evaluate (P, replicate);
  isTried = ~any (isna (Z), 2);
  Z = Z(isTried, :);
  state.data = addRows (state.data, P(isTried, :), Z, replicate(isTried), ...
                        stage);
  kind = 'verify';
  if strcmp (stage, 'infill')
    kind = 'infill';
  end
  state.spent.(kind) = state.spent.(kind) + rows (Z);
  state.spent.failed = state.spent.failed + sum (any (isnan (Z), 2));
  state.surrogates = fitSurrogates (state.data, problem, state.surrogates);
end

%!test
%! pkg load stk
%! rand ('twister', 1);
%! C = struct ('names', {{'a'}}, 'limits', [0; 1], ...
%!             'targets', struct ('value', 1.5, 'tol', 0.05));
%! C.options.maxFunEvals = 3;
%! problem = newProblem (C, []);
%! X = rand (8, 1);
%! data = addRows (newData (1, 1), X, 1 + X, ones (8, 1), 'plan');
%! state = newState (data, fitSurrogates (data, problem), []);
%! f = @(P, r) 1 + P + 0 ./ (r < 3);
%! state = runRows (state, problem, f, [0.5; 0.5; 0.5; 0.5], 'verify');
%! assert (state.data.replicate(9:end), [1; 2; 3]);
%! assert (budgetLeft (state, problem), 0);
%! assert (state.spent.failed, 1);
%! assert (isnan (state.data.Z), [false(10, 1); true]);
%!test
%! % a set that the budget leaves out is no failure
%! pkg load stk
%! C = struct ('names', {{'a'}}, 'limits', [0; 1], ...
%!             'targets', struct ('value', 1.5, 'tol', 0.05));
%! problem = newProblem (C, []);
%! X = (0:7)' / 7;
%! data = addRows (newData (1, 1), X, 1 + X, ones (8, 1), 'plan');
%! state = newState (data, fitSurrogates (data, problem), []);
%! f = @(P, r) merge (r > 1, NA (size (P)), 1 + P);
%! state = runRows (state, problem, f, [0.5; 0.5], 'infill');
%! assert (rows (state.data.Z), 9);
%! assert ([state.spent.infill, state.spent.failed], [1, 0]);
