% Every command that writes, killed at several moments and started again: it
% leaves what it would have left undisturbed. Two kills each, with
% DECALIOC_SOAK=1 (make soak) seven.

%!function result = afterKills (base, words, delays)
%!  % killed after each of the delays (s), with all that it has started
%!  root = fileparts (fileparts (which ('startProgram')));
%!  program = shellQuote (fullfile (root, 'bin', 'decalioc'));
%!  for delay = delays
%!    system (sprintf (['cd %s && timeout -s KILL %g %s %s > /dev/null ' ...
%!                      '2>&1 < /dev/null; true'], shellQuote (base), ...
%!                     delay, program, words));
%!  end
%!  [result.status, result.out] = startCommand (base, words);
%!endfunction

%!function n = finishedRuns (folder)
%!  n = numel (glob (fullfile (folder, 'optim', '*', '*', 'record.json')));
%!endfunction

%!shared base, delays
%! base = tempname ();
%! mkdir (base);
%! delays = [0.6, 1.8];
%! if strcmp (getenv ('DECALIOC_SOAK'), '1')
%!   delays = [0.3, 0.5, 0.7, 0.9, 1.2, 1.6, 2.2];
%! end

%!test
%! % new: the same files as from a call that nobody killed
%! [status, out] = startCommand (base, 'new --model Repose whole');
%! assert (status == 0, out);
%! again = afterKills (base, 'new --model Repose killed', delays);
%! if again.status ~= 0     % the last of them had time to finish
%!   assert (! isempty (strfind (again.out, 'is there already')), again.out);
%! end
%! [status, out] = system (sprintf ('diff -r %s/whole %s/killed', base, base));
%! assert (status == 0, out);

%!test
%! % run, diagnose, report, export: no finished run is lost, the result is that
%! % of a case that nobody killed
%! both = {'calm', 'hunted'};
%! for k = 1:2
%!   folder = fullfile (base, both{k});
%!   standInCase (folder);
%!   writeLoadInput (folder, 'optim.targetStd = {[0.02, 0.05], 0.02};');
%!   text = "function effects = loadEffects ()\neffects = {'gain'};\nend\n";
%!   writeAtomic (fullfile (folder, 'loadEffects.m'), text);
%!   weighedResults (folder);
%!   for words = {'run', 'diagnose', 'report', 'export'}
%!     call = [words{1}, ' ', both{k}];
%!     before = finishedRuns (folder);
%!     if k == 1
%!       [status, out] = startCommand (base, call);
%!     else
%!       done = afterKills (base, call, delays);
%!       [status, out] = deal (done.status, done.out);
%!     end
%!     assert (any (status == [0, 2]), out);
%!     assert (finishedRuns (folder) >= before);
%!   end
%! end
%! assert (finishedRuns (fullfile (base, 'calm')), ...
%!         finishedRuns (fullfile (base, 'hunted')));
%! html = fileread (fullfile (base, 'hunted', 'results', 'report.html'));
%! assert (! isempty (strfind (html, '</html>')));
%! known = @(name, file) jsondecode (fileread (fullfile (base, name, file)));
%! file = fullfile ('results', 'calibration.json');
%! assert (known ('hunted', file).params, known ('calm', file).params);
%! file = fullfile ('gap', 'gap.json');
%! assert (known ('hunted', file).which.verdict, ...
%!         known ('calm', file).which.verdict);
%! sorted = @(name) sort (strsplit (fileread (fullfile (base, name, ...
%!                                             'results', 'runs.csv')), "\n"));
%! assert (sorted ('hunted'), sorted ('calm'));

%!test
%! % ended with all its workers, as a queue or a closed terminal does: no file
%! % octave-workspace. Now and then parcellfun takes the signal for an error of its
%! % own while it sends, and the calibration goes on until it gets another one
%! folder = fullfile (base, 'queued');
%! standInCase (folder);
%! writeLoadInput (folder);
%! writeAtomic (fullfile (folder, 'DEMmodels', 'First', 'runscript'), ...
%!              "sleep 100\n");
%! root = fileparts (fileparts (which ('startProgram')));
%! program = shellQuote (fullfile (root, 'bin', 'decalioc'));
%! [~, pid] = system (sprintf (['cd %s && { setsid %s run > said 2>&1 < ' ...
%!                              '/dev/null & echo $!; }'], ...
%!                             shellQuote (folder), program));
%! pid = str2double (pid);
%! waitUntil (@() ~isempty (glob (fullfile (folder, 'optim', 'First', '*', ...
%!                                          'runscript'))));
%! [~, list] = system (sprintf ('pgrep -g %d', pid));
%! pids = sscanf (list, '%d');
%! assert (numel (pids) > 1, list);
%! start = processStart (pid);
%! for wait = [10, 10, 120]
%!   kill (-pid, 15);
%!   last = time () + wait;
%!   while strcmp (processStart (pid), start) && time () < last
%!     pause (0.1);
%!   end
%! end
%! assert (! strcmp (processStart (pid), start));
%! waitUntil (@() system (sprintf ('pgrep -g %d > /dev/null', pid)) ~= 0);
%! assert (~isempty (strfind (fileread (fullfile (folder, 'said')), ...
%!                            'Terminated')));
%! assert (! isfile (fullfile (folder, 'octave-workspace')));

%!function yes = says (text, part)
%!  yes = ~isempty (strfind (text, part));
%!endfunction

% --- killed, interrupted and cancelled in the middle, then started again
%!test
%! folder = commandCase (fullfile (base, 'it''s here'), 'stays');
%! place = shellQuote (folder);
%! hold = fullfile (folder, 'hold');
%! state = @() nthargout (2, @startCommand, base, ['status ', place]);
%! writeAtomic (hold, '');
%! pid = startAside (folder, ['check --try ', place]);
%! waitUntil (@() says (state (), '1 running'));
%! system (sprintf ('kill -KILL %d', pid));
%! waitUntil (@() says (state (), ' 0 running'));
%! unlink (hold);
%! [status, out] = startCommand (base, ['check --try ', place]);
%! assert (status == 0, out);
%! writeAtomic (hold, '');
%! least = 2;
%! for sign = {'KILL', 'INT', ''}
%!   pid = startAside (folder, ['run ', place]);
%!   waitUntil (@() says (state (), '1 running'));
%!   out = state ();
%!   assert (says (out, sprintf ('running (process %d), stage: plan', pid)));
%!   % what was finished stays, whatever ended the one before
%!   done = str2double (regexp (out, 'plan +(\d+) of 16', 'tokens', 'once'){1});
%!   assert (done >= least && done < 16, out);
%!   least = done;
%!   if isempty (sign{1})
%!     [status, out] = startCommand (base, ['cancel ', place]);
%!     assert (status, 0);
%!     assert (says (out, 'its Octave was ended'));
%!     assert (~says (out, '; 0 run(s) ended here'), out);
%!   else
%!     system (sprintf ('kill -s %s -- -%d', sign{1}, pid));
%!   end
%!   waitUntil (@() isempty (processStart (pid)));
%!   waitUntil (@() says (state (), ' 0 running'));
%!   assert (says (state (), 'stopped in the stage: plan'));
%! end
%! unlink (hold);
%! [status, out] = startCommand (base, ['run ', place]);
%! assert (status == 0, out);
%! [status, out] = startCommand (base, ['cancel ', place]);
%! assert (status, 0);
%! assert (says (out, 'no Octave worked in it; 0 run(s)'));

%!test
%! % Ctrl-C at a terminal, before the first run and with runs under way: it
%! % ends, and says what is kept
%! folder = commandCase (fullfile (base, 'it''s here'), 'stopped');
%! writeAtomic (fullfile (folder, 'hold'), '');
%! root = fileparts (fileparts (which ('startProgram')));
%! program = shellQuote (fullfile (root, 'bin', 'decalioc'));
%! call = shellQuote ([program, ' run ', shellQuote(folder)]);
%! for delay = [1.5, 5, 7]
%!   [~, out] = system (sprintf (['(sleep %g; printf ''\003''; sleep 9) | ', ...
%!                                'timeout 60 script -qec %s /dev/null'], ...
%!                               delay, call));
%!   assert (says (out, 'stopped. Finished runs are kept'), out);
%!   waitUntil (@() says (nthargout (2, @startCommand, folder, 'status'), ...
%!                        ' 0 running'));
%! end

% SPDX-License-Identifier: GPL-3.0-only
