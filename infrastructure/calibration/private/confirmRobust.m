% CONFIRMROBUST  How the robust search on the DEM evaluates a set.
%
% CALL: WAY = confirmRobust (PROBLEM)
%
% WAY       struct, see calibrateOnDEM (searchOnDEM)
%
% In each iteration one batch of runs is made: at the set that is evaluated
% where it is likelier than the present one (moveTo), else at that, where all
% runs so far are. The surrogates are fitted to all runs, and every evaluation
% is their mean response at its set, the Jacobian that of this mean. Further
% trials in an iteration cost no run; nor does a set that is confirmed.

function way = confirmRobust (problem)
  way = struct ('kept', find (problem.calibrate), ...
                'respond', @(p, book) meanResponse (p, book, problem), ...
                'slopes', @(p, f, book) slopesOf (p, book, problem), ...
                'isOver', @(book) whyOver (book, problem), ...
                'judge', @(p, why, book) robustEnd (book, problem));
  way.weights = 1 ./ problem.part(way.kept)';
  % a residual within its tolerance is no end here, as it may be chance; and it is
  % that of all runs together: bookStep says what the runs of the set gave
  way.settings = struct ('tolRes', -Inf (1, numel (way.kept)), 'maxIter', Inf, ...
                         'say', @(text) []);
end

function [z, book] = meanResponse (p, book, problem)
  if book.ran ~= book.iteration
    book = moved (book, problem, p);
    final = confirmSet (book.state, problem);
    if ~final.converged
      book.state = confirmingRuns (book.state, final, problem);
    end
    book.state = bookStep (book.state, problem, 'DEM', book.iteration, book.say);
    book.ran = book.iteration;
  end
  z = predictSurrogate (book.state.surrogates, p);
end

function book = moved (book, problem, varargin)
  if book.state.wrong < problem.options.maxIter
    [book.state, wasWrong] = moveTo (book.state, problem, varargin{:});
    book.state.wrong = book.state.wrong + wasWrong;
  end
end

function state = confirmingRuns (state, final, problem)
  n = max (1, floor (problem.options.sets));   % runAndFit looks at the budget
  if final.probability >= problem.options.unsure
    % more than one run is hardly missing: CPUs may be left idle
    n = min (n, max (1, problem.options.replicates - final.n));
  end
  stage = merge (final.n > 0, 'replicate', 'verify');
  p = state.found.params;
  state = runAndFit (state, problem, repmat (p, n, 1), stage);
  state = describedAt (state, withCare (state, problem), p);
end

function state = describedAt (state, problem, p)
  state.found = mergeFields (state.found, ...
                             describeSet (state.surrogates, problem, p));
end

function [J, book] = slopesOf (p, book, problem)
  J = surrogateJacobian (book.state.surrogates, problem, p) .* ...
      problem.part(problem.calibrate)';
end

% Replicates cannot help where the mean is clearly outside, or every run fails.
function why = whyOver (book, problem)
  options = problem.options;
  final = confirmSet (book.state, problem);
  if final.converged
    why = 'the set is confirmed';
  elseif ~isempty (nthargout (2, @keepApart, book.state, problem))
    why = 'its runs contradict those of another source';
  elseif budgetLeft (book.state, problem) < 1
    why = 'no DEM runs are left';
  elseif isClearlyOut (final, problem) && ...
         (book.state.wrong >= options.maxIter || ~isempty (final.conflict))
    why = 'clearly outside, and no other set is in reach';
  else
    why = whyNoHelp (final, book.state, problem);
  end
end

% Why further runs of the set do not help, of which none is clearly outside.
function why = whyNoHelp (final, state, problem)
  options = problem.options;
  why = '';
  if final.isRestConfirmed || anyHopeless (final.unjudged, state.unjudged)
    why = 'its runs lack a result';
  elseif final.equal > 0 && final.probability >= options.confidence
    why = 'its runs are equal';
  elseif ismember (final.params, failedSets (state.data, problem), 'rows')
    why = 'its runs fail';
  elseif final.outcomes.onceMore < options.confidence && ...
         final.outcomes.alone >= options.confidence
    why = 'too few runs are left to bound how often they end in another way';
  end
end

% Further runs bring no result back that so many packings lack. What was set aside at
% the start does not keep the others from being confirmed.
function yes = anyHopeless (unjudged, aside)
  unjudged = unjudged([unjudged.isFit] & ~ismember ({unjudged.name}, aside));
  yes = any (tooOftenNone ([unjudged.lacks]', [unjudged.tried]') > 0.95);
end

function yes = isClearlyOut (final, problem)
  [share, spread] = toleranceShare (problem, final.residual', ...
                                    final.residualSd');
  yes = final.n >= problem.options.replicates && ...
        any ((share - 1) ./ max (spread, realmin) > problem.options.apart);
end

function [book, isEnd] = robustEnd (book, problem)
  book = moved (book, problem);
  book.state.final = confirmSet (book.state, problem);
  isEnd = ~isempty (book.stop) || ~isempty (whyOver (book, problem));
  if isEnd
    book.state = handBack (book.state, problem);
  end
end

% Where the found set is not confirmed, the one that this case has run and that
% is likeliest to meet the targets is handed back (among sets without a chance
% the one that misses least); the surrogates hold all runs, so a lucky single
% run does not win. The conflict, which decides what is said, is looked up anew.
function state = handBack (state, problem)
  proposed = state.found.params;
  if state.final.converged
    state.final.untested = zeros (0, numel (proposed));
    return
  end
  X = setsThatRan (state, problem);
  if ~isempty (X)
    state = describedAt (state, problem, bestOf (X, proposed, state, problem));
  end
  if isempty (state.found.conflict) && ~state.found.within
    state.found.conflict = findConflict (state.surrogates, problem);
  end
  isTried = any (sameSet ([state.data.X; state.found.params], proposed, ...
                          problem.limits));
  state.final = confirmSet (state, problem);
  state.final.untested = proposed(1:1 - isTried, :);
end

function X = setsThatRan (state, problem)
  data = runsThatCount (state.data, problem);
  isOurs = ~strcmp (data.stage, 'import') & ...
           all (isfinite (data.Z(:, problem.calibrate)), 2);
  X = insideLimits (unique (data.X(isOurs, :), 'rows'), problem.limits);
  [yes, nearest] = isAllowed (X, problem);
  X = X(yes & all (X == nearest, 2), :);
end

% The set in hand stays where another one is hardly better.
function p = bestOf (X, p, state, problem)
  [chance, share] = meetProbability (state.surrogates, problem, X);
  worst = max (share, [], 2);
  better = problem.options.better;
  [~, order] = sortrows ([-round(chance / better), worst]);
  best = order(1);
  here = find (sameSet (X, p, problem.limits), 1);
  if isempty (here) || chance(here) < chance(best) - better || ...
     (chance(best) < better && worst(here) > 1.05 * worst(best))
    p = X(best, :);
  end
end

%!function state = judged (state, problem)
%!  state.wrong = Inf;
%!  book = struct ('state', state, 'stop', 'by the user');
%!  state = confirmRobust (problem).judge ([], '', book).state;
%!endfunction

%!test
%! % three good runs are not given up for a set that was never run; what was
%! % imported is no run of this case
%! [problem, state, ~, f] = smallCalibration ();
%! problem.options.replicates = 4;
%! good = [0.5, 1];
%! problem.value = f (good);
%! % equal runs would count once
%! state.evaluate = newEvaluate (@(P, E, r) f (P) + 1e-3 * [r, -r]);
%! state = runAndFit (state, problem, repmat (good, 3, 1), 'verify');
%! state.found = describeSet (state.surrogates, problem, [0.52, 0.96]);
%! state.found.conflict = {};
%! out = judged (state, problem);
%! assert (out.final.params, good);
%! assert (out.final.n, 3);
%! assert (out.final.untested, [0.52, 0.96]);
%! assert (isempty (out.found.conflict));
%! state.data.stage(:) = {'import'};
%! out = judged (state, problem);
%! assert (out.final.params, [0.52, 0.96]);
%! assert (isempty (out.final.untested));
%!test
%! % out of reach: the conflict is found again, the nearest run handed back
%! [problem, state] = smallCalibration ();
%! problem.value = [4, 9];
%! state.found.conflict = {};
%! state.found = mergeFields (state.found, describeSet (state.surrogates, ...
%!                                                      problem, [1, 2]));
%! out = judged (state, problem);
%! assert (out.final.n, 1);
%! assert (out.final.ending.code, 'conflict');
%! assert (out.final.ending.conflict, {'y'});

% SPDX-License-Identifier: GPL-3.0-only
