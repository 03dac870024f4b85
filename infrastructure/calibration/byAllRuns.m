% BYALLRUNS  How the robust search on the DEM evaluates a set.
%
% CALL: WAY = byAllRuns (PROBLEM)
%
% PROBLEM   struct of newProblem
% WAY       struct, see calibrateOnDEM (searchOnDEM)
%
% In each iteration one batch of runs is made: at the set that is evaluated
% where it is likelier than the present one (moveTo), else at that, where all
% runs so far are. The surrogates are fitted to all runs, and every evaluation
% is their mean response at its set, the Jacobian that of this mean. Further
% trials in an iteration cost no run; nor does a set that is confirmed.

function way = byAllRuns (problem)
  way = struct ('kept', find (problem.calibrate), ...
                'respond', @(p, book) meanResponse (p, book, problem), ...
                'slopes', @(p, f, book) slopesOf (p, book, problem), ...
                'isOver', @(book) whyOver (book, problem));
  way.weights = 1 ./ problem.part(way.kept)';
  % a residual within its tolerance is no end here, as it may be chance
  way.settings = struct ('tolRes', -Inf (1, numel (way.kept)), 'maxIter', Inf);
end

function [z, book] = meanResponse (p, book, problem)
  state = book.state;
  if book.ran ~= book.iteration
    if book.wrong < problem.options.maxIter
      [state, wasWrong] = moveTo (state, problem, p);
      book.wrong = book.wrong + wasWrong;
    end
    final = confirmSet (state, problem);
    if ~final.converged
      state = confirmingRuns (state, final, problem);
    end
    book.state = bookStep (state, 'DEM', book.iteration);
    book.ran = book.iteration;
  end
  z = predictSurrogate (state.surrogates, p);
end

function state = confirmingRuns (state, final, problem)
  % where more than one run is likely to be missing no CPU is left idle
  n = max (1, problem.options.replicates - final.n);
  if final.probability < problem.options.unsure
    n = Inf;
  end
  n = min (n, max (1, floor (problem.options.sets)));   % runAndFit: the budget
  stage = 'verify';
  if final.n > 0
    stage = 'replicate';
  end
  p = state.found.params;
  state = runAndFit (state, problem, repmat (p, n, 1), stage);
  problem.avoid = failedSets (state.data, problem);
  state.found = mergeFields (state.found, ...
                             describeSet (state.surrogates, problem, p));
end

function [J, book] = slopesOf (p, book, problem)
  J = surrogateJacobian (book.state.surrogates, problem, p) .* ...
      problem.part(problem.calibrate)';
end

% Replicates cannot help where the mean is clearly outside, or every run fails.
function why = whyOver (book, problem)
  state = book.state;
  final = confirmSet (state, problem);
  [share, spread] = toleranceShare (problem, final.residual', ...
                                    final.residualSd');
  isOut = final.n >= problem.options.replicates && ...
          any ((share - 1) ./ max (spread, realmin) > problem.options.apart);
  mayMove = book.wrong < problem.options.maxIter;
  failed = failedSets (state.data, problem);
  why = '';
  if final.converged
    why = 'the set is confirmed';
  elseif budgetLeft (state, problem) < 1
    why = 'no DEM runs are left';
  elseif final.equal > 0 && final.probability >= problem.options.confidence
    why = 'its runs are equal';
  elseif ismember (final.params, failed, 'rows')
    why = 'its runs fail';
  elseif isOut && (~mayMove || ~isempty (state.found.conflict))
    why = 'clearly outside, and no other set is in reach';
  end
end
