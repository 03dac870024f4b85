% PUBLISHEDSTAGE  The published DEM stage: nonlin_residmin straight on the DEM.
%
% CALL: STATE = publishedStage (STATE, PROBLEM, EVALUATE, SAY)
%
% STATE, PROBLEM, EVALUATE, SAY  as for calibrateOnDEM
%
% Finite differences as published, with three changes: the step of each
% parameter moves the responses by 4 times the scatter of one run (from the
% surrogates; between 2 and 20 % of the box), the d runs of a Jacobian go as
% one batch, and a set that was run is not run again. Stops at options.maxIter,
% options.tolfun, all residuals within tolerance, or the budget; the best set
% that was run becomes the found set. A failed run in a Jacobian is replaced by
% the surrogate's derivative.
%
% See also: calibrateOnDEM, confirmSet

function state = publishedStage (state, problem, evaluate, say)
  lo = problem.limits(1, :);
  width = diff (problem.limits);
  d = numel (lo);
  reserve = min (problem.options.replicates, ...
                 floor (budgetLeft (state, problem) / 2));
  memory = containers.Map ('KeyType', 'char', 'ValueType', 'any');
  [X, Z] = knownSets (state.data);
  memory('X') = X;
  memory('Z') = Z;
  memory('limits') = problem.limits;
  memory('new') = newData (d, columns (state.data.Z));
  memory('left') = budgetLeft (state, problem) - reserve;
  run = @(P) remembered (P, memory, evaluate);
  f = @(u) residualAt (lo + u(:)' .* width, run, problem);
  J = @(u, hook) differences (u(:)', hook.f, run, state, problem);
  limits = struct ('tolRes', problem.tol(problem.calibrate), ...
                   'maxIter', problem.options.maxIter);
  stop = @(u, vals, phase) userInt (u, vals, phase, true, limits);
  settings = optimset ('lbound', zeros (d, 1), 'ubound', ones (d, 1), ...
                       'dfdp', J, 'MaxIter', problem.options.maxIter, ...
                       'TolFun', problem.options.tolfun, ...
                       'user_interaction', stop);
  u = (state.found.params - lo) ./ width;
  try
    nonlin_residmin (f, min (max (u, 0), 1)', settings);
  catch err
    say (['published stage ended early: ', err.message]);
  end
  state = takeOver (state, problem, memory);
  say (sayStep (state));
end

% One row a set: the mean of its finished runs.
function [X, Z] = knownSets (data)
  isWhole = all (isfinite (data.Z), 2);
  [X, ~, group] = unique (data.X(isWhole, :), 'rows');
  Z = zeros (rows (X), columns (data.Z));
  for t = 1:columns (Z)
    Z(:, t) = accumarray (group(:), data.Z(isWhole, t), [rows(X), 1], @mean);
  end
end

function Z = remembered (P, memory, evaluate)
  X = memory('X');
  known = memory('Z');
  Z = NaN (rows (P), columns (known));
  where = zeros (rows (P), 1);
  for i = 1:rows (P)
    same = sameSet (X, P(i, :), memory('limits'));
    where(i) = max ([0; find(same)]);
  end
  seen = where > 0;
  Z(seen, :) = known(where(seen), :);
  if sum (~seen) > memory('left')
    error ('DEcalioc:publishedStage:noConvergence', ...
           'the budget of DEM runs is spent');
  end
  if any (~seen)
    Z(~seen, :) = evaluate (P(~seen, :), ones (sum (~seen), 1));
    memory('X') = [X; P(~seen, :)];
    memory('Z') = [known; Z(~seen, :)];
    made = ~seen & ~any (isna (Z), 2);
    memory('new') = addRows (memory('new'), P(made, :), Z(made, :), ...
                             ones (sum (made), 1), 'verify');
    memory('left') = memory('left') - sum (~seen);
  end
end

function f = residualAt (p, run, problem)
  r = targetResidual (problem, p, run (p));
  f = r(problem.calibrate)';
end

function J = differences (u, f, run, state, problem)
  lo = problem.limits(1, :);
  width = diff (problem.limits);
  use = problem.calibrate;
  p = lo + u .* width;
  surrogate = surrogateJacobian (state.surrogates, problem, p);
  noise = sqrt ([state.surrogates(use).noiseVar]);
  [~, slope] = targetResidual (problem, p, ...
                               predictSurrogate (state.surrogates, p));
  noise = noise .* abs (slope(use)) ./ problem.part(use);
  step = 4 * min (noise' ./ max (abs (surrogate), 1e-6), [], 1);
  step = min (max (step, 0.02), 0.2);
  step(u + step > 1) = -step(u + step > 1);
  P = lo + (u + full (diag (step))) .* width;
  r = targetResidual (problem, P, run (P));
  J = (r(:, use)' - f(:)) ./ step;
  bad = any (~isfinite (J), 1);
  J(:, bad) = surrogate(:, bad) .* problem.part(use)';
end

function state = takeOver (state, problem, memory)
  new = memory('new');
  state.data = addRows (state.data, new.X, new.Z, new.replicate, 'verify');
  state.spent.verify = state.spent.verify + rows (new.X);
  state.spent.failed = state.spent.failed + sum (any (isnan (new.Z), 2));
  [X, Z] = knownSets (state.data);
  mine = ismember (X, [new.X; state.found.params], 'rows');
  X = X(mine, :);
  r = targetResidual (problem, X, Z(mine, :));
  worst = max (toleranceShare (problem, r), [], 2);
  [least, best] = min ([worst; Inf]);
  state.surrogates = fitSurrogates (state.data, problem, state.surrogates);
  p = state.found.params;
  if isfinite (least)
    p = X(best, :);
  end
  state.found = mergeFields (state.found, ...
                             describeSet (state.surrogates, problem, p));
  state.found.conflict = {};
  state = bookStep (state, 'DEM', 1);
end

%!shared problem, state, s
%! [problem, state, s] = smallCalibration ();

%!test
%! % the budget holds and nothing is run twice
%! problem.options.maxFunEvals = 9;
%! f = @(P, r) [3 + P(:, 1) + P(:, 2) / 2, 1 + P(:, 1) + P(:, 2) / 2.5];
%! problem.value = [4, 1.92];
%! out = publishedStage (state, problem, f, @(x) []);
%! assert (out.spent.verify <= 9);
%! X = out.data.X(13:end, :);
%! assert (rows (unique (X, 'rows')), rows (X));
%! assert (numel (out.history), 1);
%!test
%! % the start is known: it is not run again, a failed repeat does not hide it,
%! % and what is worse does not take its place
%! problem.options.maxFunEvals = 5;
%! p = [0.5, 1];
%! f = @(P, r) [4.05 + 4 * sum(abs (P - p), 2), 2 + 0 * P(:, 1)];
%! state.data = addRows (state.data, [p; p], [f(p); NaN, NaN], [1; 2], ...
%!                       'infill');
%! out = publishedStage (state, problem, f, @(x) []);
%! assert (out.found.params, p);
%! assert (out.spent.failed, 0);
%! assert (~ismember (p, out.data.X(15:end, :), 'rows'));
