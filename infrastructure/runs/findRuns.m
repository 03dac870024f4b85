% FINDRUNS  Finds the runs of a list of jobs that are in the store already.
%
% CALL: RUNS = findRuns (JOBS, CASE)
%
%   JOBS  1 x n struct array, see newJobs
%   CASE  see newCase
%   RUNS  1 x n cell, see readRun: the run with the job's key, or []; with the
%         reading that the case asks for
%
% Of several runs with one key the first of these: ok, ended without a valid
% result, ended but not evaluated, failed.

function runs = findRuns (jobs, Case)
  runs = cell (1, numel (jobs));
  Case.hashes = hashModels (Case);
  for model = unique ({jobs.model})
    mine = find (strcmp ({jobs.model}, model{1}));
    h = Case.hashes(strcmp ({Case.models.name}, model{1}));
    names = runFoldersOf (Case, model{1}, jobs(mine));
    [found, keys, worth] = scan (runPlace (Case, model{1}), names, h);
    for i = mine
      hits = find (strcmp (keys, jobs(i).key));
      if ~isempty (hits)
        [~, best] = max (worth(hits));
        runs{i} = found{hits(best)};
      end
    end
  end
end

function [runs, keys, worth] = scan (place, names, h)
  runs = cellfun (@(name) readRun ([place, '/', name], h), names, ...
                  'UniformOutput', false);
  keys = repmat ({''}, size (names));
  worth = zeros (size (names));
  for i = find (~cellfun (@isempty, runs))'
    keys{i} = runs{i}.key;
    status = givenField (runs{i}, 'status', 'ended');
    worth(i) = 1 + [3, 2, 1] * strcmp (status, {'ok'; 'invalid'; 'ended'});
  end
end

%!test
%! % a run of a model that does not call LIGGGHTS: with the build and, as cron has
%! % no HOME, without it
%! Case = readyCase ();
%! tidy = slurmFake ('', '', {'liggghts', 'other'});
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(2);
%! failedRecord (job, prepareRun (job, Case), 'invalid', 'x', 'output');
%! clear tidy
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(2);
%! assert (findRuns (job, Case){1}.key, job.key);
%! assert ([runsOfCase(Case).isCurrent], true);
%!test
%! % a simulation that ended but was not evaluated goes before one that failed
%! Case = readyCase ();
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(2);
%! for status = {'timeout', ''}
%!   folder = prepareRun (job, Case);
%!   if isempty (status{1})
%!     writeAtomic (fullfile (folder, 'end.mark'), "0 1.0 finished\n");
%!   else
%!     failedRecord (job, folder, status{1}, 'too slow', 'time');
%!   end
%! end
%! assert (findRuns (job, Case){1}.folder, folder);

% SPDX-License-Identifier: GPL-3.0-only
