% A cluster of three nodes whose files appear late: one node dies in mid-plan
% and comes back, one is drained, the controller is restarted. 40 runs; with
% DECALIOC_SOAK=1 (make soak) 200.

%!shared n, folder, outcome
%! n = 40;
%! if strcmp (getenv ('DECALIOC_SOAK'), '1')
%!   n = 200;
%! end
%! folder = tempname ();

% A program mv in front of the real one: the end mark of a run appears up to 4 s
% after its job has ended, as with the attribute cache of a network file system.
%!function line = lateFiles (folder)
%!  place = fullfile (folder, 'late');
%!  mkdir (place);
%!  text = {'#!/bin/bash', ...
%!          'if [ "$2" = end.mark ]; then', ...
%!          '  late="sleep $((RANDOM % 4)).5; cd \"$PWD\"; /bin/mv $*"', ...
%!          '  (setsid bash -c "$late" > /dev/null 2>&1 < /dev/null &)', ...
%!          'else', '  exec /bin/mv "$@"', 'fi', ''};
%!  writeAtomic (fullfile (place, 'mv'), strjoin (text, "\n"));
%!  system (['chmod +x ', shellQuote(fullfile (place, 'mv'))]);
%!  line = sprintf ('export PATH=%s:$PATH', shellQuote (place));
%!endfunction

% What happens to the cluster while the plan goes on, in a shell of its own:
% each deed when so many runs have started. A node that dies has work and takes
% all its processes with it.
%!function meddle (folder, cluster, n)
%!  deeds = {'c=%s; starts=%s/optim/First/starts; t=%s', ...
%!           'after () { until [ "$(wc -l < $starts)" -ge $1 ]; do', ...
%!           '  sleep 0.1; done 2> /dev/null; touch $t/meddled-$2; }', ...
%!           'after %d node', ...
%!           'until squeue -h -t R -w n2 | grep -q .; do sleep 0.1; done', ...
%!           'kill -9 $(cat $c/run/slurmd-n2.pid)', ...
%!           'for p in /proc/[0-9]*; do', ...
%!           '  grep -qz ^SLURMD_NODENAME=n2 $p/environ &&', ...
%!           '    kill -9 ${p#*c/}', 'done 2> /dev/null', ...
%!           '(sleep 20; slurmd -N n2) &', ...
%!           'after %d control; p=$(cat $c/run/slurmctld.pid); kill $p', ...
%!           'while kill -0 $p 2> /dev/null; do sleep 0.1; done; slurmctld', ...
%!           'after %d drain', ...
%!           'scontrol update NodeName=n3 State=DRAIN Reason=test', ...
%!           'after %d resume; until', ...
%!           '  scontrol update NodeName=n3 State=RESUME; do sleep 1', ...
%!           'done 2> /dev/null; wait; touch $t/over', ''};
%!  text = sprintf (strjoin (deeds, "\n"), cluster, folder, folder, ...
%!                  round ([0.2, 0.4, 0.6, 0.9] * n));
%!  file = fullfile (folder, 'meddle.sh');
%!  writeAtomic (file, text);
%!  system (['setsid bash ', file, ' > /dev/null 2>&1 < /dev/null &']);
%!endfunction

%!testif ; slurmTestReady ()
%! config = getenv ('SLURM_CONF');
%! setenv ('SLURM_TEST_NODE_TIMEOUT', '10');
%! cluster = slurmTestUp (4, 3);
%! tidy = onCleanup (@() slurmTestDown (cluster));
%! unsetenv ('SLURM_TEST_NODE_TIMEOUT');
%! [Case, jobs] = slurmTestCase (folder, 1 + (1:n) / 512, 2);
%! Case.options.executor = 'slurm';
%! Case.options.slurm = struct ('poll', 0.5, 'grace', 8, 'maxInFlight', 60, ...
%!                              'before', {{lateFiles(folder)}});
%! meddle (folder, cluster, n);
%! outcome = runJobs (jobs, Case, @(s) []);
%! waitUntil (@() isfile (fullfile (folder, 'over')));  % the node comes late
%! setenv ('SLURM_CONF', config);
%! assert ({outcome.status}, repmat ({'ok'}, 1, n));
%! sums = sum (vertcat (jobs.params), 2)';
%! assert (cellfun (@(x) x(1), {outcome.results}), sums, 1e-12);
%! assert (numel (glob (fullfile (folder, 'meddled-*'))), 4);

%!testif ; ~isempty (outcome)
%! % one good record a run, and no run was made again but those of the node that
%! % died: all three nodes took part
%! files = glob (fullfile (folder, 'optim', 'First', '*', 'record.json'));
%! found = cellfun (@readRecord, files, 'UniformOutput', false);
%! found = [found{:}];
%! isOk = strcmp ({found.status}, 'ok');
%! assert (sum (isOk), n);
%! assert (numel (unique ({found(isOk).key})), n);
%! assert (all (strcmp ({found(~isOk).cause}, 'killed')));
%! starts = fileread (fullfile (folder, 'optim', 'First', 'starts'));
%! nodes = regexp (starts, '/(\S+) (n\d)$', 'tokens', 'lineanchors');
%! nodes = vertcat (nodes{:});
%! assert (unique (nodes(:, 2)), {'n1'; 'n2'; 'n3'});
%! again = numel (found) - n;
%! assert (rows (nodes) <= n + again);
%! assert (rows (nodes), numel (unique (nodes(:, 1))));
%! killed = cellfun (@(f) regexp (f, '[^/]+$', 'match', 'once'), ...
%!                   {found(~isOk).folder}, 'UniformOutput', false);
%! [~, where] = ismember (killed, regexprep (nodes(:, 1), '^.*/', ''));
%! assert (all (strcmp (nodes(where(where > 0), 2), 'n2')));
%! printf ('%d runs, %d made again; n1 %d, n2 %d, n3 %d starts\n', n, again, ...
%!         cellfun (@(x) sum (strcmp (x, nodes(:, 2))), {'n1', 'n2', 'n3'}));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');

% SPDX-License-Identifier: GPL-3.0-only
