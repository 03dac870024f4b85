% COMMANDMAIN  What bin/decalioc hands to Octave: one command.
%
% CALL: octave-cli commandMain.m NAME WORD...   in the folder of the case
%
% The exit status is that of the command, 1 after an error. Each function takes
% the folder of the toolbox, that of the case and the words of the command.

1;

function [Case, words] = caseOf (root, folder, args)
  [~, words] = commandOptions (args, struct ());
  useLiggghts (root);
  Case = withEffects (loadCase (root, folder));
end

function status = sayReport (root, folder, args)
  Case = caseOf (root, folder, args);
  writePage (Case);
  printf ('page  %s\n', fullfile (folder, 'results', 'report.html'));
  status = 0;
end

% Not to runs.csv of the case itself: the next start would take it in.
function status = sayExport (root, folder, args)
  [Case, words] = caseOf (root, folder, args);
  file = fullfile (folder, 'results', 'runs.csv');
  if isempty (words)
    [~, ~] = mkdir (fullfile (folder, 'results'));
  else
    file = words{1};
  end
  if strcmp (make_absolute_filename (file), fullfile (folder, 'runs.csv'))
    error ('DEcalioc:sayExport:exists', ...
           ['the table cannot be %s: the next start would take it in, and ' ...
            'the runs are in the store already. Take another name.'], file);
  end
  n = exportRuns (file, Case, gatherRuns (Case));
  printf ('%d runs  %s\n', n, file);
  status = 0;
end

% The guards end the runs when their Octave is gone; runs of which the guard has
% lost its Octave already are ended here. Of a store that several cases share,
% only arrays that hold a run of this case are cancelled.
function status = sayCancel (root, folder, args)
  Case = caseOf (root, folder, args);
  holder = lockHolder (Case.folder);
  if strcmp (holder.state, 'unknown')
    error ('DEcalioc:sayCancel:otherHost', ...
           ['process %d on %s works in this case. Call decalioc cancel ' ...
            'there: runs that are ended while it looks on are tried again. ' ...
            'If it is gone for sure, delete %s.'], holder.pid, holder.host, ...
           fullfile (Case.folder, 'decalioc.lock'));
  end
  runs = runsOfCase (Case);
  isOpen = ismember ({runs.state}, {'running', 'waiting'});
  isAlive = strcmp (holder.state, 'alive');
  if isAlive
    stopProcess (holder, Case.folder);
  end
  arrays = cancelArrays (Case, runs(isOpen));
  running = runs(strcmp ({runs.state}, 'running') & [runs.isCurrent]);
  cellfun (@endRun, {running.folder}, 'UniformOutput', false);
  for look = 1:50
    left = cellfun (@(f) nthargout (2, @runPids, f), {running.folder});
    if ~any (left)
      break
    end
    pause (0.2);
  end
  words = {'no Octave worked in it', 'its Octave was ended'};
  printf ('%s; %d run(s) ended here, %d job array(s) on Slurm\n', ...
          words{1 + isAlive}, sum (~left), arrays);
  printf ('Finished runs are kept; the same command goes on.\n');
  status = 0;
end

% Ctrl-C first: Octave then ends its runs itself.
function stopProcess (holder, folder)
  for signal = {'INT', 'TERM', 'KILL'}
    system (sprintf ('kill -%s %d 2> /dev/null', signal{1}, holder.pid));
    for look = 1:20
      if ~strcmp (lockHolder (folder).state, 'alive')
        return
      end
      pause (0.1);
    end
  end
end

function n = cancelArrays (Case, runs)
  n = 0;
  for name = executorNames ()
    batches = batchLedger (Case.store, name{1});
    isOurs = arrayfun (@(b) any (ismember (b.folders, {runs.folder})), batches);
    if ~any (isOurs)
      continue
    end
    queue = describeExecutor (name{1});
    [ok, text] = queue.cancel ({batches(isOurs).name});
    if ~ok
      error ('DEcalioc:cancelArrays:runFailed', ...
             ['%s must cancel the jobs, got: %s. Try again when the queue ' ...
              'answers.'], queue.title, strtrim (text));
    end
    n = n + sum (isOurs);
  end
end

% The trial is a run of the model that decalioc new --model makes, with few
% grains. Status 2 where something that is needed is missing or does not work.
function status = sayDoctor (root, folder, args)
  options = commandOptions (args, struct ('no_run', 'flag'));
  line = @(name, text) printf ('%-10s %s\n', name, text);
  line ('DEcalioc', [strtrim(fileread (fullfile (root, 'VERSION'))), ' in ', ...
                     root]);
  line ('Octave', sprintf ('%s (tested with 7.3)', version ()));
  for name = {'struct', 'optim', 'parallel', 'stk'}
    found = pkg ('list', name{1});
    line (name{1}, found{1}.version);
  end
  choice = useLiggghts (root);
  isGood = ~isempty (choice.program);
  words = {'MISSING', [choice.program, ' ', choice.version]};
  line ('LIGGGHTS', words{1 + isGood});
  line ('', choice.why);
  line ('', choice.how);
  line ('CPUs', sprintf ('%d', nproc ()));
  sayPrograms (line);
  if isGood && ~options.no_run
    [isGood, text] = trialRun (root);
    line ('trial run', text);
  end
  status = 2 * ~isGood;
end

function sayPrograms (line)
  what = {'mpirun', 'runs on several CPUs'; 'gnuplot', 'pictures'; ...
          'sbatch', 'runs on a Slurm cluster'; ...
          'stdbuf', 'the last words of a run that fails'; ...
          'pkill', 'ending runs'};
  for k = 1:rows (what)
    path = file_in_path (getenv ('PATH'), what{k, 1});
    if isempty (path)
      path = 'not there';
    end
    line (what{k, 1}, sprintf ('%s (for %s)', path, what{k, 2}));
  end
end

function [isGood, text] = trialRun (root)
  place = tempname ();
  tidy = onCleanup (@() system (['rm -rf ', shellQuote(place)]));
  model = fullfile (place, 'DEMmodels', 'Trial');
  evalc ('sayNew (root, place, {''--model'', ''Trial'', place})');
  head = fullfile (model, 'data.head');
  writeAtomic (head, [fileread(head), "\nvariable filledSolid equal 4e-6\n"]);
  raw = struct ('root', root, 'folder', place);
  raw.Input = struct ('model', {{'Trial'}}, 'cpu', 1, 'maxCPU', 1, ...
                      'numOfSam', 4, 'timeout', 120);
  raw.optim = struct ('targetVal', {{[30, 0.01, 0.02]}}, ...
                      'tolRes', {{[0.1, 0.1, 0.1]}});
  raw.modelVars = struct ();
  raw.assign = {'coefFrictionPP'};
  raw.paramLims = [0.4; 0.6];
  try
    Case = newCase (raw);
    record = executeLocal (newJobs (Case, 0.5, [], 1, 'plan'), Case, ...
                           @(state) []);
    isGood = strcmp (record.status, 'ok');
    text = sprintf ('%s, %s', record.status, record.message);
    if isGood
      text = sprintf ('ok, %.1f s, angle of repose %.1f deg', ...
                      record.seconds, record.results(1));
    end
  catch err
    isGood = false;
    text = err.message;
  end
end

function result = carryOut (root, folder, words)
  commands = struct ('new', @sayNew, 'check', @sayCheck, ...
                     'status', @sayStatus, 'report', @sayReport, ...
                     'export', @sayExport, 'cancel', @sayCancel, ...
                     'doctor', @sayDoctor, 'runs', @sayLibrary, ...
                     'forget', @(varargin) sayLibrary (varargin{:}, true));
  command = commands.(words{1});
  result.exitStatus = command (root, folder, words(2:end));
end

root = fileparts (fileparts (fileparts (mfilename ('fullpath'))));
addpath (fullfile (root, 'infrastructure'));
startMain (@(root, folder) carryOut (root, folder, argv ()), root);

%!test
%! % what each command says, and its exit status
%! raw = standInCase (tempname ());
%! writeLoadInput (raw.folder);
%! said = {'cancel', 0, 'no Octave worked in it; 0 run(s) ended here'; ...
%!         'export', 0, '0 runs  '; ...
%!         'export . runs.csv', 1, 'the table cannot be '; ...
%!         'doctor --no-run', [], 'gnuplot    '; ...
%!         'runs', 2, ' holds no runs'};
%! for row = said'
%!   [status, text] = startCommand (raw.folder, row{1});
%!   assert (isempty (row{2}) || status == row{2}, text);
%!   assert (~isempty (strfind (text, row{3})), text);
%! end
%! assert (isfile (fullfile (raw.folder, 'results', 'runs.csv')));

%!function [Case, folder, cancel] = oneRun ()
%!  raw = standInCase (tempname ());
%!  writeLoadInput (raw.folder);
%!  writeAtomic (fullfile (raw.folder, 'DEMmodels', 'First', 'runscript'), ...
%!               "sleep 100\n");
%!  Case = newCase (raw);
%!  folder = prepareRun (newJobs (Case, [1, 2], [], 1, 'plan')(1), Case);
%!  cancel = @() nthargout (2, @startCommand, raw.folder, 'cancel');
%!endfunction
%!test
%! % a run whose Octave is this one; a case in which one works elsewhere
%! [Case, folder, cancel] = oneRun ();
%! startRun (folder, Case.root);
%! while isempty (runPids (folder))
%!   pause (0.1);
%! end
%! assert (~isempty (strfind (cancel (), '; 1 run(s) ended here, 0 job')));
%! assert (readEndMark (folder).reason, 'killed');
%! writeAtomic (fullfile (Case.folder, 'decalioc.lock'), "elsewhere 1 1\n");
%! assert (~isempty (strfind (cancel (), 'process 1 on elsewhere works in')));
%!test
%! % of two arrays in the queue, the one that holds a run of this case
%! [Case, folder, cancel] = oneRun ();
%! words = fullfile (Case.folder, 'words');
%! scancel = fullfile (Case.folder, 'scancel');
%! writeAtomic (scancel, sprintf ("#!/bin/sh\necho \"$@\" > '%s'\n", words));
%! system (['chmod +x ', scancel]);
%! for name = {'decalioc-a', 'decalioc-b'}
%!   batch = fullfile (Case.store, 'optim', '.slurm', name{1});
%!   mkdir (batch);
%!   writeAtomic (fullfile (batch, 'tasks'), sprintf ("k\t%s\n", folder));
%!   folder = '/some/other/run';
%! end
%! before = getenv ('PATH');
%! back = onCleanup (@() setenv ('PATH', before));
%! setenv ('PATH', [Case.folder, ':', before]);
%! assert (~isempty (strfind (cancel (), '1 job array(s) on Slurm')));
%! assert (regexp (fileread (words), '--jobname=decalioc-a(?!.*decalioc-b)'));
