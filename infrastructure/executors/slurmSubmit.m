% SLURMSUBMIT  Prepares runs and writes down that they go to Slurm together.
%
% CALL: FLIGHT = slurmSubmit (FLIGHT, PICKS, JOBS, CASE, OPT)
%
%   FLIGHT  see slurmAttach
%   PICKS   1 x k indices into JOBS, models with the same number of CPUs
%   JOBS    1 x n struct array, see newJobs
%   CASE    see newCase
%   OPT     see slurmOptions
%
% Makes the run folders and a batch folder <store>/optim/.slurm/<name> whose
% file tasks tells which task of the array is which run. The name is unique and
% becomes the job name: the array is found by it even when its number was never
% heard of. Nothing is sent yet, see slurmSend.
%
% Errors: DEcalioc:slurmSubmit:badValue, those of prepareRun
%
% See also: slurmSend, slurmLedger

function flight = slurmSubmit (flight, picks, jobs, Case, opt)
  models = Case.models;
  [~, k] = ismember ({jobs(picks).model}, {models.name});
  limits = [models(k).timeout];
  minutes = slurmMinutes (opt.time, limits);
  % the guard ends a run before Slurm does: it is exact and leaves an end mark
  unset = isnan (limits);
  limits(unset) = arrayfun (@defaultLimit, models(k(unset)));
  seconds = max (1, floor (min (limits, 60 * minutes - 10)));
  lines = cell (1, numel (picks));
  for i = 1:numel (picks)
    job = jobs(picks(i));
    folder = prepareRun (job, Case);
    checkPath (folder);
    writeAtomic (fullfile (folder, 'limit'), sprintf ("%d\n", seconds(i)));
    flight.folder{picks(i)} = folder;
    lines{i} = sprintf ("%s\t%s\n", job.key, folder);
  end
  batch = struct ('name', newName (lines), 'path', '', ...
                  'n', numel (picks), 'left', numel (picks), ...
                  'cpu', models(k(1)).cpu, 'minutes', minutes, ...
                  'isSent', false);
  batch.path = fullfile (Case.store, 'optim', '.slurm', batch.name);
  [~, ~] = mkdir (batch.path);
  writeAtomic (fullfile (batch.path, 'tasks'), [lines{:}]);
  flight.batches(end + 1) = batch;
  flight.batch(picks) = numel (flight.batches);
  flight.task(picks) = 1:numel (picks);
  flight.status(picks) = 'o';
  flight.isOld(picks) = false;
  flight.since(picks) = NaN;
end

function checkPath (folder)
  if any (ismember (folder, "\t\n\r"))
    error ('DEcalioc:slurmSubmit:badValue', ...
           ['slurmSubmit: the path of the run store must be free of tabs ' ...
            'and line breaks, got %s. Rename the folder.'], folder);
  end
end

function name = newName (lines)
  text = sprintf ('%s %.17g %.17g %d', lines{1}, time (), cputime (), ...
                  getpid ());
  name = ['decalioc-', hash('md5', text)(1:12)];
end

%!test
%! [Case, jobs] = slurmTestCase (tempname (), 1:3, 0);
%! Case.models.timeout = 7;
%! flight = slurmAttach (jobs, Case.store);
%! flight = slurmSubmit (flight, [1, 3], jobs, Case, slurmOptions ([]));
%! assert (flight.status, 'oqo');
%! assert (flight.task([1, 3]), [1, 2]);
%! assert (fileread (fullfile (flight.folder{3}, 'limit')), "7\n");
%! assert (flight.batches.isSent, false);
%! % without a limit of the user's, the one that earlier runs teach
%! Case.models.timeout = NaN;
%! Case.models.seconds = [10, 10, 10];
%! later = slurmSubmit (flight, 2, jobs, Case, slurmOptions ([]));
%! assert (fileread (fullfile (later.folder{2}, 'limit')), "200\n");
%! % a new start knows of all
%! again = slurmAttach (jobs, Case.store);
%! assert (again.status, 'ooo');
%! assert (again.folder, later.folder);
%! assert (again.isOld, [true, true, true]);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (Case.folder, 's');
%!error id=DEcalioc:slurmSubmit:badValue
%! [Case, jobs] = slurmTestCase (tempname (), 1, 0);
%! Case.store = [Case.store, "\tx"];
%! flight = slurmAttach (jobs, Case.store);
%! slurmSubmit (flight, 1, jobs, Case, slurmOptions ([]));
