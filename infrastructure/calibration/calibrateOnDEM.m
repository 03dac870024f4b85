% CALIBRATEONDEM  Levenberg-Marquardt on the DEM: corrects and confirms the set.
%
% CALL: STATE = calibrateOnDEM (STATE, PROBLEM, SAY)
%
% STATE     struct of newState
% PROBLEM   struct of newProblem; options used: maxIter, maxFunEvals, tolfun,
%           replicates, confidence, sets, method
% SAY       handle, gets one line of text an iteration (userInt)
%
% nonlin_residmin on costFunction of DEM results, from the found set, never more
% runs than budgetLeft says. What options.method changes:
%
%               'robust'                         'published'
%   evaluation  one batch of runs an iteration,  one run; none where the set
%               then the mean response as all    was run before
%               runs tell it
%   Jacobian    of the surrogates of all runs    finite differences of runs
%   rows        of the targets, in tolerances    all of costFunction
%   ends        once confirmSet is satisfied     by tolRes, maxIter, tolfun
%
% 'robust': the first evaluation verifies the found set. A search that ends
% before the set is confirmed is begun anew at the surest set, as its sums of
% squares are out of date; maxIter counts the sets that turned out wrong, not
% the small steps along slopes that the surrogates know. STATE.final is the
% judgement.

function state = calibrateOnDEM (state, problem, say)
  % ran: iteration of the last runs; wrong: sets that turned out wrong; stop:
  % what userInt said when it stopped
  book = struct ('state', state, 'iteration', 0, 'ran', -1, 'wrong', 0, ...
                 'stop', '');
  isPublished = strcmp (problem.options.method, 'published');
  if isPublished
    way = bySingleRuns (problem);
  else
    way = byAllRuns (problem);
  end
  way.say = say;
  while true
    way.maxIter = max (0, problem.options.maxIter - book.wrong);
    [p, why, book] = searchOnDEM (way, problem, book);
    state = book.state;
    if isPublished
      state = publishedResult (state, problem, p, why);
      break
    end
    if book.wrong < problem.options.maxIter
      [state, wasWrong] = moveTo (state, problem);
      book.wrong = book.wrong + wasWrong;
    end
    state.final = confirmSet (state, problem);
    book.state = state;
    if ~isempty (book.stop) || ~isempty (way.isOver (book))
      state = handBack (state, problem);
      break
    end
  end
  state.reason = state.final.reason;
end

% The set of nonlin_residmin; where its last trial has no result, the best that
% has one. What the published program calls met, is met; what a robust
% calibration would make of it, is said.
function state = publishedResult (state, problem, p, why)
  isFinished = all (isfinite (state.data.Z), 2);
  run = keepRows (state.data, ...
                  strcmp (state.data.stage, 'verify') & isFinished);
  if ~isempty (run.X) && ~any (sameSet (run.X, p, problem.limits))
    r = targetResidual (problem, run.X, run.Z)(:, problem.calibrate);
    [~, best] = min (sumsq (r, 2));
    p = run.X(best, :);
  end
  state.found = mergeFields (state.found, ...
                             describeSet (state.surrogates, problem, p));
  final = confirmSet (state, problem);
  rest = sprintf (['make more runs at this set, until the probability that ' ...
                   'it meets the targets, now %.0f %%, is %.0f %%'], ...
                  100 * final.probability, 100 * problem.options.confidence);
  if final.converged
    rest = 'call this set calibrated, too';
  elseif final.probability < problem.options.wrong
    rest = 'go on to other sets';
  end
  final.met = final.n > 0 & abs (final.residual') <= problem.tol;
  final.converged = all (final.met(problem.calibrate));
  final.untested = zeros (0, numel (p));
  if final.converged
    final.limit = '';
  end
  final.reason = ['published method, one run a set: ', why, '; a robust ' ...
                  'calibration would ', rest];
  state.final = final;
end

% One Levenberg-Marquardt search from the found set. WAY (byAllRuns,
% bySingleRuns) holds respond (handle [Z, BOOK] = f (P, BOOK), makes runs),
% slopes (handle [J, BOOK] = f (p, residual, BOOK)), kept (rows of costFunction
% that are fitted), weights, maxIter, settings (struct for userInt), say, isOver
% (handle, text: why it should end beside what userInt says). P 1 x d, WHY text.
%
% nonlin_residmin hands nothing on from one evaluation to the next: the nested
% functions share BOOK.
function [p, why, book] = searchOnDEM (way, problem, book)
  lo = problem.limits(1, :);
  width = diff (problem.limits);
  d = numel (lo);
  settings = optimset ('lbound', zeros (d, 1), 'ubound', ones (d, 1), ...
                       'dfdp', @slopes, 'weights', way.weights, ...
                       'MaxIter', way.maxIter, ...
                       'TolFun', problem.options.tolfun, ...
                       'user_interaction', @watch);
  u = (book.state.found.params - lo) ./ width;
  u = min (max (u, 0), 1)';
  why = 'the search for active limits of the parameters failed';
  try
    [u, ~, cvg, info] = nonlin_residmin (@residual, u, settings);
    why = 'the sum of squares no longer decreases';
    if cvg < 0
      why = info.user_interaction.info{1};
    elseif cvg == 0
      why = 'the number of iterations is reached';
    end
  catch err
    % see leastSquaresInBox; the runs are made
    if ~any (strcmp (err.message, {'not successful', 'pivot is zero'}))
      rethrow (err);
    end
  end
  p = lo + u(:)' .* width;

  function f = residual (unit)
    full = problem.cost (lo(:) + unit(:) .* width(:), @respond);
    f = full(way.kept)(:);
  end

  function z = respond (set, varargin)
    [z, book] = way.respond (set(:)', book);
    z = z(:);
  end

  function J = slopes (unit, hook)
    [J, book] = way.slopes (lo + unit(:)' .* width, hook.f(:), book);
  end

  function [stop, reason] = watch (unit, vals, phase)
    reason = '';
    if ~strcmp (phase, 'done')
      [reason, book] = whyStop (lo + unit(:)' .* width, vals, phase, way, book);
    end
    stop = ~isempty (reason);
  end

end

function [why, book] = whyStop (p, vals, phase, way, book)
  vals.iteration = book.iteration;
  book.iteration = vals.iteration + 1;
  runs = sum (isAfterPlan (book.state.data));
  settings = way.settings;
  settings.say = @(text) way.say (sprintf ('%s; %d runs since the plan', ...
                                           text, runs));
  [stop, why] = userInt (p(:), vals, phase, true, settings);
  if stop
    book.stop = why;
  else
    why = way.isOver (book);
  end
end

%!shared problem, state, f
%! pkg load stk
%! pkg load -nodeps struct optim
%! rand ('twister', 2);
%! randn ('twister', 2);
%! C.names = {'a', 'b', 'c'};
%! C.limits = [0, 0, 0; 1, 1, 1];
%! C.targets = struct ('value', {4, 2}, 'tol', 0.02);
%! C.options = struct ('maxFunEvals', 12, 'replicates', 3, 'sets', 2);
%! problem = newProblem (C, []);
%! f = @(P, r) [3 + 2 * P(:, 1) - P(:, 3), 1 + P(:, 1) + P(:, 2)] .* ...
%!             (1 + 0.005 * randn (rows (P), 2));
%! X = rand (12, 3);
%! data = addRows (newData (3, 2), X, f (X, 1), ones (12, 1), 'plan');
%! s = fitSurrogates (data, problem);
%! state = newState (data, s, calibrateOnKriging (s, problem));
%! state.evaluate = newEvaluate (@(P, E, r) f (P, r));

%!test
%! s = improveByInfill (state, problem, @(text) []);
%! s = calibrateOnDEM (s, problem, @(text) []);
%! assert (s.final.converged);
%! assert (s.final.n >= 3);
%! p = s.final.params;
%! assert (3 + 2 * p(1) - p(3), 4, 0.08);
%! assert (rows (s.data.X), 12 + sum (isAfterPlan (s.data)));

%!test
%! % failures are no success: two runs at each of the four sets that may be
%! % tried; the budget is spent to the last run and never overshot
%! state.evaluate = newEvaluate (@(P, E, r) NaN (rows (P), 2));
%! s = calibrateOnDEM (state, problem, @(text) []);
%! assert ([sum(isAfterPlan (s.data)), s.budget.failed], [8, 8]);
%! assert (~ s.final.converged);
%! small = problem;
%! small.options.maxFunEvals = 5;
%! s = calibrateOnDEM (state, small, @(text) []);
%! assert ([sum(isAfterPlan (s.data)), s.budget.failed], [5, 5]);

%!test
%! % published finite differences on the DEM
%! problem.options.method = 'published';
%! s = calibrateOnDEM (state, problem, @(text) []);
%! assert (sum (isAfterPlan (s.data)) <= 12);
%! assert (all (abs (s.final.residual) < 0.06));

%!test
%! % the last set that may be tried is clearly wrong: said as it is, and no
%! % more runs than show it
%! problem.options.maxIter = 0;
%! problem.options.method = 'robust';
%! state.found = describeSet (state.surrogates, problem, [0.1, 0.1, 0.9]);
%! state.found.conflict = {};
%! s = calibrateOnDEM (state, problem, @(text) []);
%! assert (s.history(end).params, [0.1, 0.1, 0.9]);
%! assert (abs (s.history(end).residual(1)) > 0.2);
%! assert (sum (isAfterPlan (s.data)) <= 4);
