% EXECUTESTATIC  Carries out runs as published: equal stacks, one a process.
%
% CALL: RECORDS = executeStatic (JOBS, CASE, REPORT)
%
%   JOBS, CASE, REPORT, RECORDS  see executeLocal
%
% Each model's plan is cut into stacks beforehand (SplitToCPU, SplitExPlan),
% which parcellfun hands to Start. A process that got long runs is waited for
% while others have nothing to do: kept to compare with, choose 'local'.

function records = executeStatic (jobs, Case, report)
  records = repmat (newRecord (jobs(1), ''), 1, numel (jobs));
  for k = 1:numel (Case.models)
    mine = find (strcmp ({jobs.model}, Case.models(k).name));
    if ~isempty (mine)
      records(mine) = runStacks (jobs(mine), k, Case);
    end
  end
  report (struct ('total', numel (jobs), 'done', numel (jobs), 'running', 0, ...
                  'failed', sum (~strcmp ({records.status}, 'ok')), ...
                  'seconds', sum ([records.seconds])));
end

function records = runStacks (jobs, k, Case)
  plan = vertcat (jobs.params);
  [nProc, runsPerCPU, remainder] = ...
    SplitToCPU (Case.options.maxCPU, rows (plan), Case.models(k).cpu);
  [main, rest] = SplitExPlan (plan, nProc, runsPerCPU, remainder);
  stacks = cellfun (@(s) [s, repmat(k, rows (s), 1)], [main, rest], ...
                    'UniformOutput', false);
  names = {Case.models.name};
  [~, kept] = parcellfun (nProc, @(s) Start (s, names, Case, jobs), stacks, ...
                          'UniformOutput', false, 'VerboseLevel', 0);
  records = [kept{:}];
end

%!test
%! Case = readyCase ();
%! jobs = newJobs (Case, [1, 2; 3, 4; 5, 6], [], 1, 'plan');
%! records = executeStatic (jobs, Case, @(s) []);
%! assert ({records.key}, {jobs.key});
%! assert (vertcat (records([1, 3, 5]).results), [3, 2; 7, 12; 11, 30], 1e-12);
%!test
%! % replicates of one set are runs with seeds of their own
%! Case = readyCase ();
%! jobs = newJobs (Case, [1, 2; 1, 2; 1, 2], [], [1; 2; 3], 'verify');
%! records = executeStatic (jobs, Case, @(s) []);
%! assert ({records.key}, {jobs.key});
%! assert ([records.seed], [jobs.seed]);
%! assert (numel (unique ({records.folder})), 6);

% SPDX-License-Identifier: GPL-3.0-only
