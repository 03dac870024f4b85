% BESTSET  The parameter set of the finished runs that comes nearest.
%
% CALL: BEST = bestSet (CASE, RUNS, COST)
%
%   CASE  see newCase
%   RUNS  see runsOfCase
%   COST  cost function, see newProblem; []: the published residual
%   BEST  scalar struct: params 1 x d, results 1 x T (mean over packings),
%         residual 1 x T (rows of the cost function), runs (packings, of the
%         target that has fewest), worst (largest residual over its tolerance;
%         below 1: all targets are met), isMet; [] where no set has a result
%         for every target that is calibrated
%
% Only runs that count today and have no effect switched on are looked at.

function best = bestSet (Case, runs, cost)
  best = [];
  isGood = strcmp ({runs.state}, 'ok') & [runs.isCurrent];
  runs = runs(isGood & arrayfun (@(r) isPlain (r.job, Case), runs));
  if isempty (runs)
    return
  end
  sets = cellfun (@(j) toDigits (j.params(:)'), {runs.job}, ...
                  'UniformOutput', false);
  [X, ~, which] = unique (vertcat (sets{:}), 'rows');
  [Z, count] = meansOf (runs, which, rows (X), Case.targets);
  problem = newProblem (Case, cost);
  residual = targetResidual (problem, X, Z);
  used = problem.calibrate;
  share = toleranceShare (problem, residual);
  share(isnan (share)) = Inf;
  [worst, k] = min (max (share, [], 2));
  if isfinite (worst)
    best = struct ('params', X(k, :), 'results', Z(k, :), ...
                   'residual', residual(k, :), ...
                   'runs', min (count(k, used)), 'worst', worst, ...
                   'isMet', worst < 1);
  end
end

function yes = isPlain (job, Case)
  neutral = neutralEffects (Case);
  given = reshape (job.effects, 1, []);
  yes = isempty (given) || isequal (given, neutral) || ...
        (atLastLevel (given, Case) && ...
         ~any (strcmp (job.stage, {'gap', 'cure'})));
end

% Mean result of each set and target, and over how many runs.
function [Z, count] = meansOf (runs, which, n, targets)
  Z = zeros (n, numel (targets));
  count = Z;
  for i = 1:numel (runs)
    ofModel = find ([targets.model] == runs(i).model);
    index = [targets(ofModel).index];
    k = which(i);
    Z(k, ofModel) = Z(k, ofModel) + reshape (runs(i).results(index), 1, []);
    count(k, ofModel) = count(k, ofModel) + 1;
  end
  Z = Z ./ count;
end

%!test
%! % First gives a + b and a b, Second a - b; the mean over two packings counts
%! Case = readyCase ();
%! Case.targets(1).value = 5;
%! Case.targets(2).value = 6;
%! Case.targets(3).value = 1;
%! assert (isempty (bestSet (Case, runsOfCase (Case), [])));
%! jobs = [newJobs(Case, [3, 2.1; 1, 2], [], 1, 'plan'), ...
%!         newJobs(Case, [3, 2.1], [], 2, 'calibration')];
%! runJobs (jobs, Case, @(state) []);
%! best = bestSet (Case, runsOfCase (Case), []);
%! assert (best.params, [3, 2.1]);
%! assert (best.results, [5.1, 6.3, 0.9], 1e-12);
%! assert (best.residual, [0.02, 0.05, -0.1], 1e-12);
%! assert (best.runs, 2);
%! assert (best.worst, 5, 1e-9);
%! assert (~best.isMet);
%! Case.targets(3).role = 'holdout';
%! Case.targets(2).tol = 0.2;
%! Case.targets(1).tol = 0.1;
%! assert (bestSet (Case, runsOfCase (Case), []).isMet);

% SPDX-License-Identifier: GPL-3.0-only
