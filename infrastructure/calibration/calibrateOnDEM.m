% CALIBRATEONDEM  Levenberg-Marquardt on the DEM: corrects and confirms the set.
%
% CALL: STATE = calibrateOnDEM (STATE, PROBLEM, SAY)
%
% nonlin_residmin on costFunction of DEM results, from the found set, never more
% runs than budgetLeft says. What options.method changes:
%
%               'robust' (confirmRobust)             'published' (confirmPublished)
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
% judgement of confirmSet, with untested: 1 x d, the set that the surrogates had
% proposed instead and that was never run; 0 x d: none.

function state = calibrateOnDEM (state, problem, say)
  % ran: iteration of the last runs; stop: what userInt said when it stopped; say:
  % gets a line about each step
  book = struct ('state', state, 'iteration', 0, 'ran', -1, 'stop', '', 'say', say);
  way = confirmRobust (problem);
  if strcmp (problem.options.method, 'published')
    way = confirmPublished (problem);
  end
  way.say = say;
  isEnd = false;
  while ~isEnd
    [p, why, book] = searchOnDEM (way, problem, book);
    [book, isEnd] = way.judge (p, why, book);
  end
  state = book.state;
  state.final = endingCause (state.final, state, problem);
  state.reason = state.final.reason;
end

% One search from the found set. WAY holds respond (handle [Z, BOOK] = f (P,
% BOOK), makes runs), slopes (handle [J, BOOK] = f (P, RESIDUAL, BOOK)), kept
% (rows of costFunction that are fitted), weights, settings (struct for
% userInt), say, isOver (handle, text: why it should end beside what userInt
% says), judge (handle [BOOK, ISEND] = f (P, WHY, BOOK): state.final, and
% whether there is no other search). P 1 x d, WHY text.
%
% nonlin_residmin hands nothing on from one evaluation to the next: the nested
% functions share BOOK.
function [p, why, book] = searchOnDEM (way, problem, book)
  d = columns (problem.limits);
  most = max (0, problem.options.maxIter - book.state.wrong);
  settings = optimset ('lbound', zeros (d, 1), 'ubound', ones (d, 1), ...
                       'dfdp', @slopes, 'weights', way.weights, ...
                       'MaxIter', most, 'TolFun', problem.options.tolfun, ...
                       'user_interaction', @watch);
  u = toUnit (book.state.found.params, problem.limits);
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
  p = inBox (u);

  function p = inBox (unit)
    p = toAllowed (fromUnit (unit(:)', problem.limits), problem);
  end

  function f = residual (unit)
    full = problem.cost (inBox (unit)', @respond);
    f = full(way.kept)(:);
  end

  function z = respond (set, varargin)
    [z, book] = way.respond (set(:)', book);
    z = z(:);
  end

  function J = slopes (unit, hook)
    [J, book] = way.slopes (inBox (unit), hook.f(:), book);
  end

  function [stop, reason] = watch (unit, vals, phase)
    reason = '';
    if ~strcmp (phase, 'done')
      [reason, book] = whyStop (inBox (unit), vals, phase, way, book);
    end
    stop = ~isempty (reason);
  end

end

function [why, book] = whyStop (p, vals, phase, way, book)
  vals.iteration = book.iteration;
  book.iteration = book.iteration + 1;
  runs = sum (isAfterPlan (book.state.data));
  settings = way.settings;
  since = countText (runs, 'run');
  if ~isfield (settings, 'say')
    settings.say = @(text) way.say (sprintf ('%s; %s since the plan', text, since));
  end
  [stop, why] = userInt (p(:), vals, phase, true, settings);
  if stop
    book.stop = why;
  else
    why = way.isOver (book);
  end
end

%!shared problem, state, law
%! [problem, state, ~, law] = smallCalibration ();
%! problem.options.maxFunEvals = 12;
%! problem.options.replicates = 3;
%! problem.options.sets = 2;
%! problem.value = [4, 1.9];
%! state.found.params = [0.6, 1.1];
%! state.evaluate = newEvaluate (@(P, E, r) law (P) .* ...
%!                                          (1 + 0.005 * randn (rows (P), 2)));

%!test
%! s = improveByInfill (state, problem, @(text) []);
%! s = calibrateOnDEM (s, problem, @(text) []);
%! assert (s.final.converged);
%! assert (s.final.n >= 3);
%! assert (law (s.final.params) ./ [4, 1.9], [1, 1], 0.02);
%! assert (rows (s.data.X), 12 + sum (isAfterPlan (s.data)));

%!test
%! % failures are no success: two runs at each of the four sets that may be
%! % tried; the budget is spent to the last run and never overshot
%! failing = state;
%! failing.evaluate = newEvaluate (@(P, E, r) NaN (rows (P), 2));
%! for most = [12, 5]
%!   small = setfield (problem, 'options', 'maxFunEvals', most);
%!   s = calibrateOnDEM (failing, small, @(text) []);
%!   assert ([sum(isAfterPlan (s.data)), s.budget.failed], ...
%!           min (8, most) * [1, 1]);
%!   assert (~ s.final.converged);
%! end

%!test
%! % published finite differences on the DEM
%! published = setfield (problem, 'options', 'method', 'published');
%! s = calibrateOnDEM (state, published, @(text) []);
%! n = sum (isAfterPlan (s.data));
%! assert (n >= 3 && n <= 12 && s.final.n > 0);
%! assert (all (abs (s.final.residual) < 0.06));

%!test
%! % the last set that may be tried is clearly wrong: said as it is, and no
%! % more runs than show it
%! problem.options.maxIter = 0;
%! state.found = describeSet (state.surrogates, problem, [0.1, 0.1]);
%! state.found.conflict = {};
%! s = calibrateOnDEM (state, problem, @(text) []);
%! assert (s.history(end).params, [0.1, 0.1]);
%! assert (abs (s.history(end).residual(2)) > 0.2);
%! assert (sum (isAfterPlan (s.data)) <= 4);

% SPDX-License-Identifier: GPL-3.0-only
