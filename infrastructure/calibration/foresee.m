% FORESEE  The runs of the plan of a case, and what they will cost.
%
% CALL: F = foresee (CASE, RUNS [, SAY])
%
%   CASE  see newCase
%   RUNS  see runsOfCase
%   SAY   handle that takes a line on the runs of runs.csv (none is said)
%   F     scalar struct:
%     plan      n x d, parameter sets of the plan
%     imported  runs of runs.csv, see newData;  library  see TOLD of libraryRuns
%     jobs      1 x n M struct array, runs of the plan
%     isDone    1 x n M logical: finished in the store, or ended there
%     seconds   1 x M, median of the model's finished runs (s); NaN: none
%     planHours core-hours of the runs of the plan that are missing; NaN where
%               a model has no finished run yet
%     mostHours the same with all that may follow: optim.maxFunEvals sets
%     problem   see newProblem
%
% Nothing is run or written. What fails is run again, so failed runs count as
% missing.

function f = foresee (Case, runs, say)
  if nargin < 3
    say = @(text) [];
  end
  f.problem = newProblem (Case);
  [data, ~, f.library] = importExisting (Case, f.problem, say, true);
  f.imported = keepRows (data, strcmp (data.stage, 'import'));
  here = Case;
  here.folder = '';                     % so that no plan is written
  [f.plan, E] = newPlan (data, here);
  f.jobs = struct ('model', {}, 'key', {});
  f.isDone = false (1, 0);
  if rows (f.plan) > 0
    E(:, end + 1:numel (Case.effectVars)) = ...
      repmat (neutralEffects (Case)(columns (E) + 1:end), rows (E), 1);
    number = replicateNumbers (data, f.plan, Case.limits);
    f.jobs = newJobs (Case, f.plan, E, number, 'plan');
    isEnded = ismember ({runs.state}, {'ok', 'invalid', 'ended'});
    keys = cellfun (@(r) r.key, {runs(isEnded).job}, 'UniformOutput', false);
    f.isDone = ismember ({f.jobs.key}, keys);
  end
  isOk = ismember ({runs.state}, {'ok', 'ended'}) & isfinite ([runs.seconds]);
  for k = 1:numel (Case.models)
    seconds = [runs(isOk & [runs.model] == k).seconds];
    f.seconds(k) = median ([seconds, NaN(1, isempty (seconds))]);
    missing(k) = sum (~f.isDone & strcmp ({f.jobs.model}, ...
                                          Case.models(k).name));
  end
  hours = f.seconds .* [Case.models.cpu] / 3600;
  o = Case.options;
  f.planHours = sum (min (missing, o.maxNewRuns) .* hours);
  f.mostHours = sum (min (missing + o.maxFunEvals, o.maxNewRuns) .* hours);
end

%!test
%! Case = readyCase ();
%! f = foresee (Case, runsOfCase (Case));
%! assert (size (f.plan), [8, 2]);
%! assert (f.isDone, false (1, 16));
%! assert (isnan (f.planHours));
%! runJobs (f.jobs(1:4), Case, @(state) []);
%! runs = runsOfCase (Case);
%! f = foresee (Case, runs);
%! assert (f.isDone, [true(1, 4), false(1, 12)]);
%! each = [median([runs([runs.model] == 1).seconds]), ...
%!         median([runs([runs.model] == 2).seconds])];
%! assert (f.planHours, 6 * sum (each) / 3600, 1e-12);
%! assert (f.mostHours, 46 * sum (each) / 3600, 1e-12);
%! assert (~isfile (fullfile (Case.folder, 'ExperimentalPlan_DoE.csv')));

% SPDX-License-Identifier: GPL-3.0-only
