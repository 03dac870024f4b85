% CALIBRATEONDEM  Calibration on DEM runs: corrects the set and confirms it.
%
% CALL: STATE = calibrateOnDEM (STATE, PROBLEM, EVALUATE, SAY)
%
% STATE     struct of newState
% PROBLEM   struct of newProblem; options used: maxIter (sets tried),
%           maxFunEvals, replicates, confidence, tolfun, sets, method
% EVALUATE  handle Z = evaluate (P, replicate)
% SAY       handle, gets one line of text a step
%
% 'robust': the found set is run with other seeds, at most sets at once; the
% runs correct the surrogates, whose Levenberg-Marquardt gives the next set when
% the present one turns out wrong. Ends when confirmSet is satisfied, or the
% budget is spent, or maxIter sets turned out wrong (a small step along slopes
% that the surrogates know does not count). 'published': nonlin_residmin with
% finite differences on DEM (see publishedStage), then the same confirmation.
% STATE.final is the judgement of confirmSet on the set that handBack chooses.
%
% See also: improveByInfill, confirmSet, handBack, publishedStage

function state = calibrateOnDEM (state, problem, evaluate, say)
  if strcmp (problem.options.method, 'published')
    state = publishedStage (state, problem, evaluate, say);
  end
  iteration = 0;
  moves = 0;
  while true
    state.final = confirmSet (state, problem);
    mayMove = moves < problem.options.maxIter;
    if state.final.converged || budgetLeft (state, problem) < 1 || ...
       (iteration > 0 && isHopeless (state, problem, mayMove))
      break
    end
    iteration = iteration + 1;
    before = state.found.params;
    state = confirmingRuns (state, problem, evaluate);
    state = recalibrate (state, problem, 'DEM', iteration, mayMove);
    moves = moves + turnedOutWrong (state, problem, before);
    say (sayStep (state));
  end
  state = handBack (state, problem);
  state.reason = state.final.reason;
end

function state = confirmingRuns (state, problem, evaluate)
  % where more than one run is likely to be missing no CPU is left idle
  n = max (1, problem.options.replicates - state.final.n);
  if state.final.probability < 0.9
    n = Inf;
  end
  n = min (n, max (1, floor (problem.options.sets)));   % runRows: the budget
  stage = 'verify';
  if state.final.n > 0
    stage = 'replicate';
  end
  state = runRows (state, problem, evaluate, ...
                   repmat (state.found.params, n, 1), stage);
end

% A small step along a slope that the surrogates know is no new set.
function yes = turnedOutWrong (state, problem, before)
  problem.avoid = failedSets (state.data, problem);
  yes = ~isequal (before, state.found.params) && ...
        meetProbability (state.surrogates, problem, before) < 0.2;
end

% More replicates cannot help where the mean is clearly outside, or every run
% fails, and there is no other set to go to.
function yes = isHopeless (state, problem, mayMove)
  final = state.final;
  [share, spread] = toleranceShare (problem, final.residual', ...
                                    final.residualSd');
  beyond = (share - 1) ./ max (spread, realmin);
  isOut = final.n >= problem.options.replicates && any (beyond > 3);
  if mayMove
    yes = isOut && ~isempty (state.found.conflict);
  else
    failed = failedSets (state.data, problem);
    yes = isOut || ismember (final.params, failed, 'rows');
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

%!test
%! s = improveByInfill (state, problem, f, @(text) []);
%! s = calibrateOnDEM (s, problem, f, @(text) []);
%! assert (s.final.converged);
%! assert (s.final.n >= 3);
%! p = s.final.params;
%! assert (3 + 2 * p(1) - p(3), 4, 0.08);
%! assert (rows (s.data.X), 12 + s.spent.infill + s.spent.verify);

%!test
%! % failures are no success: two runs at each of the four sets that may be
%! % tried; the budget is spent to the last run and never overshot
%! fail = @(P, r) NaN (rows (P), 2);
%! s = calibrateOnDEM (state, problem, fail, @(text) []);
%! assert (s.spent.verify, 8);
%! assert (s.spent.failed, 8);
%! assert (~ s.final.converged);
%! small = problem;
%! small.options.maxFunEvals = 5;
%! s = calibrateOnDEM (state, small, fail, @(text) []);
%! assert (s.spent.verify, 5);
%! assert (s.spent.failed, 5);

%!test
%! % published finite differences on the DEM
%! problem.options.method = 'published';
%! s = calibrateOnDEM (state, problem, f, @(text) []);
%! assert (s.spent.verify <= 12);
%! assert (all (abs (s.final.residual) < 0.06));

%!test
%! % the last set that may be tried is clearly wrong: said as it is, and no
%! % more runs than show it
%! problem.options.maxIter = 0;
%! problem.options.method = 'robust';
%! state.found = describeSet (state.surrogates, problem, [0.1, 0.1, 0.9]);
%! state.found.conflict = {};
%! s = calibrateOnDEM (state, problem, f, @(text) []);
%! assert (s.history(end).params, [0.1, 0.1, 0.9]);
%! assert (abs (s.history(end).residual(1)) > 0.2);
%! assert (s.spent.verify <= 4);
