% Faults: whatever is killed, a second start gives the result of the first.

%!shared answer, nTrials
%! nTrials = 5;
%! if strcmp (getenv ('DECALIOC_SOAK'), '1')
%!   nTrials = 50;
%! end
%! folder = [tempname(), ' it''s an ', char([195, 188]), ' plan'];
%! faultCase (folder);
%! root = fileparts (which ('faultProgram'));
%! words = shellQuote (fullfile (root, 'faultProgram.m'));
%! [status, out, err] = startProgram (folder, words);
%! answer = fileread (fullfile (folder, 'answer.csv'));

%!test
%! % the undisturbed start, on a path with spaces, a quote and an umlaut
%! assert (numel (strfind (answer, "\n")), 8);
%! assert (isempty (strfind (answer, 'NaN')));

%!test
%! % kill -9 at random moments; the seed makes the moments the same each time,
%! % as far as a busy machine can
%! rand ('twister', str2double (['0', getenv('DECALIOC_FAULT_SEED')]) + 1);
%! targets = {'octave', 'simulation', 'worker', 'guard', 'mpirun'};
%! for k = 1:nTrials
%!   target = targets{mod (k - 1, numel (targets)) + 1};
%!   faultTrial (tempname (), target, 0.5 + 3.5 * rand (), answer);
%! end

%!test
%! % the clock is set back between two starts: the runs are found all the same
%! folder = tempname ();
%! faultCase (folder);
%! words = shellQuote (which ('faultProgram'));
%! startProgram (folder, words);
%! system (sprintf ('find %s -exec touch -d "+2 days" {} +', folder));
%! unlink (fullfile (folder, 'answer.csv'));
%! startProgram (folder, words);
%! assert (fileread (fullfile (folder, 'answer.csv')), answer);
%! assert (numel (listRunFolders (folder, 'First')), 8);

%!test
%! % corrupt and truncated records and marks: evaluated or run again
%! folder = tempname ();
%! faultCase (folder);
%! words = shellQuote (which ('faultProgram'));
%! startProgram (folder, words);
%! run = @(n, f) fullfile (folder, 'optim', 'First', sprintf ('%04d', n), f);
%! for n = 1:4
%!   text = fileread (run (n, 'record.json'));
%!   broken = {text(1:20), strrep(text, '"ok"', '"OK"'), '', char(1:50)};
%!   writeAtomic (run (n, 'record.json'), broken{n});
%! end
%! writeAtomic (run (4, 'end.mark'), '0 1');
%! unlink (fullfile (folder, 'answer.csv'));
%! startProgram (folder, words);
%! assert (fileread (fullfile (folder, 'answer.csv')), answer);
%! assert (numel (listRunFolders (folder, 'First')), 9);

%!test
%! % a read-only case folder (not for root, who may write anywhere)
%! try
%!   lockCase ('/proc/self');
%! catch err
%! end
%! assert (err.identifier, 'DEcalioc:lockCase:cannotWrite');

%!testif ; geteuid () == 0 && system ('unshare -m true 2> /dev/null') == 0
%! % a disk that fills up in mid-plan: said, nothing lost, the next start goes
%! % on
%! folder = tempname ();
%! mkdir (folder);
%! assert (system (sprintf ('mount -t tmpfs -o size=40m tmpfs %s', folder)), 0);
%! umount = onCleanup (@() system (sprintf ('umount -l %s', folder)));
%! faultCase (folder);
%! run = fullfile (folder, 'DEMmodels', 'First', 'runscript');
%! writeAtomic (run, ["if [ -d ../0004 ] && [ ! -e ../../../once ]; then\n", ...
%!   "touch ../../../once\n", ...
%!   "dd if=/dev/zero of=../../../ballast bs=1M 2> /dev/null\nfi\n", ...
%!   fileread(run)]);
%! words = shellQuote (which ('faultProgram'));
%! [status, ~, err] = startProgram (folder, words);
%! assert (status, 1);
%! assert (! isempty (strfind (err, 'finished runs are kept')), err);
%! done = glob (fullfile (folder, 'optim', '*', '*', 'record.json'));
%! assert (! isempty (done));
%! unlink (fullfile (folder, 'ballast'));
%! [status, ~, err] = startProgram (folder, words);
%! assert (err, '');
%! assert (fileread (fullfile (folder, 'answer.csv')), answer);
%! assert (all (cellfun (@isfile, done)));
%! clear umount

% SPDX-License-Identifier: GPL-3.0-only
