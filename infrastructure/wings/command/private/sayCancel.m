% SAYCANCEL  Ends what works in a case: its Octave, its runs, its job arrays.
%
% CALL: STATUS = sayCancel (ROOT, FOLDER, ARGS)
%
%   ROOT    folder of the toolbox (text)
%   FOLDER  case folder (text)
%   ARGS    cell of texts; no option is known
%   STATUS  0
%
% The Octave is ended first, so that a mistake in loadInput.m does not keep it
% alive. The guards end the runs when their Octave is gone; runs of which the
% guard has lost its Octave already are ended here. Of a store that several
% cases share, only arrays that hold a run of this case are cancelled.
%
% Errors: DEcalioc:sayCancel:otherHost, DEcalioc:cancelArrays:runFailed; those
% of loadCase and withEffects

function status = sayCancel (root, folder, args)
  commandOptions (args, struct ());
  start = time ();
  cancelMain (folder);
  holder = lockHolder (folder);
  if strcmp (holder.state, 'unknown')
    error ('DEcalioc:sayCancel:otherHost', ...
           ['process %d on %s works in this case. Call decalioc cancel ' ...
            'there: runs that are ended while it looks on are tried again. ' ...
            'If it is gone for sure, delete %s.'], holder.pid, holder.host, ...
           fullfile (folder, 'decalioc.lock'));
  end
  isAlive = strcmp (holder.state, 'alive');
  if isAlive
    stopProcess (holder, folder);
  end
  Case = caseAfter (isAlive, root, folder);
  runs = runsOfCase (Case);
  isOpen = ismember ({runs.state}, {'running', 'waiting'});
  [arrays, queues] = cancelArrays (vertcat (cell (0, 2), runs(isOpen).arrays));
  running = runs(strcmp ({runs.state}, 'running') & [runs.isCurrent]);
  ended = endRuns ({running.folder}, {runs(~isOpen).folder}, start);
  words = {'no Octave worked in it', 'its Octave was ended'};
  printf ('%s; %d run(s) ended here, %d job array(s)%s\n', ...
          words{1 + isAlive}, ended, arrays, queues);
  printf ('Finished runs are kept; the same command goes on.\n');
  status = 0;
end

% The Octave of decalioc submit; it gets a minute to end.
function cancelMain (folder)
  [job, state] = submittedJob (folder);
  if ~any (strcmp (state, {'waiting', 'running', 'unknown'}))
    return
  end
  queue = describeExecutor (job.executor);
  emptyQueue (queue, {job.name});
  for look = 1:60
    [~, state] = submittedJob (folder);
    if ~any (strcmp (state, {'waiting', 'running'}))
      break
    end
    pause (1);
  end
  printf ('the job %s of decalioc submit was cancelled\n', job.name);
end

function emptyQueue (queue, names)
  [ok, text] = queue.cancel (names);
  if ~ok
    error ('DEcalioc:cancelArrays:runFailed', ...
           ['%s must cancel the jobs, got: %s. Try again when the queue ' ...
            'answers.'], queue.title, strtrim (text));
  end
end

% Where the case cannot be loaded, what has been done is said all the same.
function Case = caseAfter (isAlive, root, folder)
  try
    Case = caseToRead (root, folder);
  catch err
    if isAlive
      printf (['its Octave was ended, and ends its runs on this machine; ' ...
               'job arrays in a queue were not looked for:\n']);
      fflush (stdout ());
    end
    rethrow (err);
  end
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

% ARRAYS  n x 2 cell, see runsOfCase.
function [n, queues] = cancelArrays (arrays)
  [n, queues] = deal (0, '');
  titles = {};
  for name = unique (arrays(:, 1))'
    queue = describeExecutor (name{1});
    ours = unique (arrays(strcmp (arrays(:, 1), name{1}), 2))';
    emptyQueue (queue, ours);
    n = n + numel (ours);
    titles{end + 1} = queue.title;
  end
  if n > 0
    queues = [' on ', strjoin(titles, ' and ')];
  end
end

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
%! waitUntil (@() ~isempty (runPids (folder)));
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
%!test
%! % a mistake that loadInput.m has got since does not keep it alive
%! [Case, ~, cancel] = oneRun ();
%! [pid, mark] = startSleep (321);
%! writeAtomic (fullfile (Case.folder, 'decalioc.lock'), ...
%!              sprintf ('%s %d %s', gethostname (), pid, mark));
%! writeLoadInput (Case.folder, 'nope (');
%! text = cancel ();
%! assert (strncmp (text, 'its Octave was ended, and ends', 30), text);
%! assert (~isempty (strfind (text, 'loadInput')), text);
%! assert (isempty (processStart (pid)));

% SPDX-License-Identifier: GPL-3.0-only
