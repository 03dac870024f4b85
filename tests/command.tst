% The command decalioc, as a user calls it: from any folder, through a link, in
% paths with blanks and quotes. Killed and interrupted: commandKilled.tst

%!shared root, base
%! root = fileparts (fileparts (which ('startProgram')));
%! base = fullfile (tempname (), 'it''s here');
%! mkdir (base);

%!function n = finishedRuns (folder)
%!  n = numel (glob (fullfile (strrep (folder, '''', '?'), 'optim', '*', ...
%!                             '*', 'record.json')));
%!endfunction

%!function yes = says (text, part)
%!  yes = ~isempty (strfind (text, part));
%!endfunction

% --- help, and calls that are not understood
%!test
%! [status, out] = startCommand (base, '--help');
%! assert (status, 0);
%! commands = regexp (out, '^  (\w+) ', 'tokens', 'lineanchors');
%! assert (numel (commands), 18);
%! % what 2 means, of each command that gives it
%! marks = {'run: not all', 'diagnose: no verdict', 'doctor: something', ...
%!          'check --try: the trial run failed', 'runs: the store is empty'};
%! assert (all (cellfun (@(m) says (out, m), marks)), out);
%! for name = [commands{:}]
%!   [status, text] = startCommand (base, [name{1}, ' --help']);
%!   assert (status, 0);
%!   assert (says (text, ['decalioc ', name{1}]));
%! end
%! [status, out] = startCommand (base, '--version');
%! assert (strtrim (out), ['decalioc ', ...
%!                         strtrim(fileread (fullfile (root, 'VERSION')))]);
%!test
%! for words = {'nonsense', 'check /nowhere', 'check', 'run --quickly', ...
%!              'status a b', 'new', 'doctor --nonsense'}
%!   [status, out] = startCommand (base, words{1});
%!   assert (status == 1, words{1});
%!   assert (numel (strtrim (out)) > 20, words{1});
%! end
%! [status, out] = startCommand (base, 'check');
%! assert (says (out, 'holds no loadInput.m'));
%! % a command or an option that is none: where the right ones are told
%! wrong = {'stauts', 'decalioc --help'; 'doctor --no-rum', '--no-run'; ...
%!          ['run --afersh ', shellQuote(commandCase (base, 'near'))], ...
%!          'decalioc run --help'};
%! for row = wrong'
%!   [status, out] = startCommand (base, row{1});
%!   assert (status, 1);
%!   assert (says (out, row{2}), out);
%! end

% --- mistakes in the input; another LIGGGHTS that is not there
%!test
%! folder = commandCase (base, 'bad');
%! setenv ('LIGGGHTS', '/nowhere/liggghts');
%! [status, out] = startCommand (base, 'check bad');
%! setenv ('LIGGGHTS', '');
%! assert (status, 1);
%! assert (says (out, '/nowhere/liggghts is not a program'));
%! file = fullfile (folder, 'loadInput.m');
%! writeAtomic (file, [strtrim(fileread (file))(1:end - 3), ...
%!                     "\nInput.maxCPU = 0;\nInput.numOfSamples = 1;\nend\n"]);
%! [status, out] = startCommand (base, 'check bad');
%! assert (status, 1);
%! assert (says (out, '2 problems in the input'));
%! assert (says (out, 'Input.maxCPU') && says (out, 'Input.numOfSamples'));

% --- check, check --try twice, run, status, export; a trial that fails
%!test
%! folder = commandCase (base, 'my case');
%! file = fullfile (folder, 'loadInput.m');
%! writeAtomic (file, [strtrim(fileread (file))(1:end - 3), ...
%!                     "optim.weights = [1, 2];\nend\n"]);
%! [status, out] = startCommand (folder, 'check');
%! assert (status, 0);
%! assert (says (out, 'WARNING   optim.weights in loadInput.m'));
%! assert (says (out, 'WARNING   no file of DEMmodels/First uses runSeed'));
%! assert (says (out, ' runs, 16 new, 0 taken from the store'));
%! assert (says (out, 'not known'));
%! [status, out] = startCommand (base, 'check --try ''my case''');
%! assert (status, 0);
%! assert (says (out, 'trial     Second: ok'));
%! assert (says (out, ' runs, 14 new, 2 taken from the store'));
%! [~, out] = startCommand (base, 'status ''my case''');
%! assert (says (out, 'one set has been tried'));
%! [status, out] = startCommand (base, 'run ''my case''');
%! assert (status, 0);
%! [status, out] = startCommand (folder, 'status');
%! assert (says (out, 'finished'));
%! assert (says (out, 'targets met: 3 of 3'));
%! [status, out] = startCommand (base, 'export ''my case'' table.csv');
%! assert (status, 0);
%! table = strsplit (strtrim (fileread (fullfile (base, 'table.csv'))), "\n");
%! assert (numel (table) - 1, finishedRuns (folder));
%! % the table is a case of its own
%! other = commandCase (base, 'other');
%! copyfile (fullfile (base, 'table.csv'), fullfile (other, 'runs.csv'));
%! [status, out] = startCommand (base, 'check other');
%! assert (says (out, 'sets taken in'));
%! [status, out] = startCommand (base, 'export other other/runs.csv');
%! assert (status, 1);
%! % afresh moves the runs aside
%! [status, out] = startCommand (base, 'run --afresh ''my case''');
%! assert (status, 0);
%! assert (numel (glob (fullfile (strrep (folder, '''', '?'), ...
%!                                'optim-*'))), 1);
%!test
%! folder = commandCase (base, 'broken');
%! writeAtomic (fullfile (folder, 'DEMmodels', 'First', 'runscript'), ...
%!              "echo 'ERROR: no such box'\nexit 1\n");
%! [status, out] = startCommand (base, 'check --try broken');
%! assert (status, 2);
%! assert (says (out, 'no such box'));
%! [~, out] = startCommand (base, 'status broken');
%! assert (says (out, 'First: failed exit status 1; ERROR: no such box'));

% --- a live view that Ctrl-C ends
%!test
%! folder = commandCase (base, 'watched');
%! [pid, mark] = startSleep (300);
%! writeAtomic (fullfile (folder, 'decalioc.lock'), ...
%!              sprintf ('%s %d %s', gethostname (), pid, mark));
%! program = shellQuote (fullfile (root, 'bin', 'decalioc'));
%! call = shellQuote (['exec ', program, ' watch ', shellQuote(folder)]);
%! system (['cd ', shellQuote(folder), ' && (timeout 60 sh -c ''until grep -qs ' ...
%!   '"state   running" screen; do sleep 0.2; done''; printf ''\003''; timeout 30 ' ...
%!   'sh -c ''until test -e ended; do sleep 0.2; done'') | (timeout 90 script ' ...
%!   '-qfec ', call, ' screen > /dev/null; echo $? > ended)']);
%! out = fileread (fullfile (folder, 'screen'));
%! status = str2double (fileread (fullfile (folder, 'ended')));
%! kill (pid, 9);
%! assert (says (out, 'state   running'), out);
%! assert (status == 0, out);
%! assert (~(says (out, 'error') || says (out, 'fatal')), out);

% --- the report, or what is missing
%!test
%! folder = commandCase (base, 'page');
%! [status, out] = startCommand (base, 'report page');
%! if isempty (which ('writePage'))
%!   assert (status, 1);
%!   assert (says (out, 'pageData'));
%! else
%!   assert (status == 0, out);
%!   assert (isfile (fullfile (folder, 'results', 'report.html')));
%! end

% --- completion in bash
%!function out = reply (words, k)
%!  root = fileparts (fileparts (which ('startProgram')));
%!  file = fullfile (root, 'share', 'bash-completion', 'completions', ...
%!                   'decalioc');
%!  text = sprintf (['. %s; COMP_WORDS=(%s); COMP_CWORD=%d; _decalioc; ' ...
%!                   'echo "${COMPREPLY[*]}"'], shellQuote (file), words, k);
%!  [~, out] = system (['bash -c ', shellQuote(text)]);
%!  out = strtrim (out);
%!endfunction
%!assert (reply ('decalioc st', 1), 'status')
%!assert (reply ('decalioc check --', 2), '--try --dry-run --help')
%!assert (reply ('decalioc new --mo', 2), '--model')
%!test
%! % each option that the help of a command has stands in its completion
%! root = fileparts (fileparts (which ('startProgram')));
%! text = fileread (fullfile (root, 'bin', 'decalioc'));
%! parts = regexp (text, '^#help (\w+)\n(.*?)^#end', 'tokens', 'lineanchors');
%! assert (numel (parts) > 15);
%! for part = parts
%!   known = strsplit (reply (['decalioc ', part{1}{1}, ' --'], 2), ' ');
%!   named = regexp (part{1}{2}, '^# +(--[a-z][a-z-]*)|\[(--[a-z][a-z-]*)', 'tokens', ...
%!                   'lineanchors');
%!   lacks = setdiff ([named{:}], known);
%!   assert (isempty (lacks), '%s %s', part{1}{1}, strjoin (lacks, ' '));
%! end

%!test
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (fileparts (base), 's');

% SPDX-License-Identifier: GPL-3.0-only
