% CALIBRATEONDEM  Calibration on DEM runs: corrects the set and confirms it.
%
% CALL: state = calibrateOnDEM (state, problem, evaluate, say)
%
% state     struct of newState
% problem   struct of newProblem; options used: maxIter (sets tried),
%           maxFunEvals, replicates, confidence, tolfun, maxCPU, method
% evaluate  handle Z = evaluate (P, replicate)
% say       handle, gets one line of text a step
%
% 'robust': the found set is run with other seeds, at most maxCPU at once; the
% runs correct the surrogates, whose Levenberg-Marquardt gives the next set when
% the present one turns out wrong. Ends when confirmSet is satisfied, or the
% budget is spent, or maxIter sets were tried. 'published': nonlin_residmin with
% finite differences on DEM (see publishedStage), then the same confirmation.
% state.final is the judgement of confirmSet.
%
% See also: improveByInfill, confirmSet, publishedStage

function state = calibrateOnDEM (state, problem, evaluate, say)
  if strcmp (problem.options.method, 'published')
    state = publishedStage (state, problem, evaluate, say);
  end
  iteration = 0;
  moves = 1;
  while true
    state.final = confirmSet (state, problem);
    if state.final.converged || budgetLeft (state, problem) < 1
      break
    end
    if isHopeless (state, problem, iteration)
      break
    end
    iteration = iteration + 1;
    before = state.found.params;
    state = confirmingRuns (state, problem, evaluate);
    state = recalibrate (state, problem, 'DEM', iteration);
    if ~isequal (before, state.found.params)
      moves = moves + 1;
      if moves > problem.options.maxIter + 1
        state.found = describeAgain (state, problem, before);
      end
    end
    say (sayStep (state));
  end
  state.reason = state.final.reason;
end

function state = confirmingRuns (state, problem, evaluate)
  missing = max (1, problem.options.replicates - state.final.n);
  n = min (missing, max (1, floor (problem.options.maxCPU)));
  stage = 'verify';
  if state.final.n > 0
    stage = 'replicate';
  end
  state = runRows (state, problem, evaluate, ...
                   repmat (state.found.params, n, 1), stage);
end

function yes = isHopeless (state, problem, iteration)
  % more replicates cannot help: the mean is clearly outside and no other set
  % is likelier
  final = state.final;
  use = problem.calibrate;
  beyond = (abs (final.residual(use)') - problem.tol(use)) ./ ...
           max (final.residualSd(use)', eps);
  yes = iteration > 0 && final.n >= problem.options.replicates && ...
        any (beyond > 3) && ~isempty (state.found.conflict);
end

function found = describeAgain (state, problem, p)
  found = state.found;
  here = describeSet (state.surrogates, problem, p);
  kept = fieldnames (here);
  for i = 1:numel (kept)
    found.(kept{i}) = here.(kept{i});
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
%! C.options = struct ('maxFunEvals', 12, 'replicates', 3, 'maxCPU', 2);
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
%! % the budget is never overshot, failures are no success
%! s = calibrateOnDEM (state, problem, @(P, r) NaN (rows (P), 2), @(text) []);
%! assert (s.spent.verify, 12);
%! assert (s.spent.failed, 12);
%! assert (~ s.final.converged);

%!test
%! % published finite differences on the DEM
%! problem.options.method = 'published';
%! s = calibrateOnDEM (state, problem, f, @(text) []);
%! assert (s.spent.verify <= 12);
%! assert (all (abs (s.final.residual) < 0.06));
