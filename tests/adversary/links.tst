% Somebody who shares a store puts links in the places of files to come. What
% they lead to stays as it is, and the runs go on.

%!function file = precious ()
%!  file = tempname ();
%!  writeAtomic (file, 'precious');
%!endfunction
%!test
%! % drafts: of records, locks, the index and surrogates
%! Case = readyCase ();
%! evaluateDEM ([1, 2], Case);
%! place = fullfile (Case.store, 'optim', 'First');
%! target = precious ();
%! for name = {sprintf('.index-%d', geteuid ()), 'claim-x', '0001/record.json'}
%!   for ending = {'', '.tmp', '.stale', '.save'}
%!     symlink (target, sprintf ('%s/%s.%d%s', place, name{1}, getpid (), ...
%!                               ending{1}));
%!   end
%! end
%! readLibrary (runPlace (Case, 'First'));
%! lock = lockCase (place, 'claim-x');
%! clear lock
%! record = readRecord (fullfile (place, '0001', 'record.json'));
%! writeRecord (fullfile (place, '0001', 'record.json'), record);
%! assert (fileread (target), 'precious');
%!test
%! % files of a run that the scripts write, and those of its model
%! Case = readyCase ();
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(1);
%! folder = takeRunFolder (runPlace (Case, 'First'));
%! target = precious ();
%! for name = {'stdout.txt', 'stderr.txt', 'pid', 'end.mark', 'end.mark.tmp', ...
%!             'getResults.late', 'data.head', 'runscript', 'in.First', ...
%!             'params.csv', 'job.json', 'record.json', 'limit', 'cpu'}
%!   symlink (target, fullfile (folder, name{1}));
%! end
%! prepareRun (job, Case, folder);
%! startRun (folder, Case.root);
%! for look = 1:200
%!   if ~isempty (readEndMark (folder))
%!     break
%!   end
%!   pause (0.05);
%! end
%! assert (readEndMark (folder).reason, 'finished');
%! record = collectRuns (job, {folder}, Case);
%! assert (strcmp (record.status, 'ok'), record.message);
%! system (sprintf ('sleep 9 & bash %s $! $(cut -d" " -f22 /proc/$!/stat) 0 %s', ...
%!                  shellQuote (fullfile (fileparts (which ('startRun')), 'watch.sh')), ...
%!                  fullfile (folder, 'getResults.late')));
%! assert (fileread (target), 'precious');
%!test
%! % a folder of a batch that is given up: nobody else's folder is emptied
%! store = tempname ();
%! mkdir (fullfile (store, 'decalioc-1'));
%! other = tempname ();
%! mkdir (other);
%! writeAtomic (fullfile (other, 'mine'), 'precious');
%! symlink (other, fullfile (store, '.ended'));
%! batchDiscard (fullfile (store, 'decalioc-1'));
%! assert (fileread (fullfile (other, 'mine')), 'precious');
%! assert (! isfolder (fullfile (store, 'decalioc-1')));
%!test
%! % a task of a job array with lines to carry out first
%! store = tempname ();
%! mkdir (store);
%! [folder, batch] = deal ([store, '/run'], [store, '/batch']);
%! mkdir (folder);
%! mkdir (batch);
%! target = precious ();
%! for name = {'stdout.txt', 'stderr.txt', 'end.mark', 'end.mark.tmp'}
%!   symlink (target, fullfile (folder, name{1}));
%! end
%! writeAtomic (fullfile (batch, 'tasks'), sprintf ("k\t%s\n", folder));
%! here = fileparts (which ('batchExecute'));
%! status = system (sprintf ('T=1 bash %s %s guard T J %s', ...
%!                           shellQuote ([here, '/batchTask.sh']), batch, ...
%!                           base64_encode (uint8 ("echo hello\nfalse\n"))));
%! assert (status, 98);
%! assert (fileread (target), 'precious');
%! assert (fileread (fullfile (folder, 'stdout.txt'))(1:6), "hello\n");
%! assert (readEndMark (folder).code, 98);

% SPDX-License-Identifier: GPL-3.0-only
