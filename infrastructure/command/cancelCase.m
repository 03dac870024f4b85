% CANCELCASE  Ends the Octave that works in a case, and its runs.
%
% CALL: DONE = cancelCase (CASE)
%
%   CASE  see newCase
%   DONE  scalar struct: octave (it was ended), runs (how many were ended on
%         this machine), arrays (job arrays that were taken out of a queue)
%
% The guards end the runs when their Octave is gone; runs of which the guard has
% lost its Octave already are ended here. Of a store that several cases share,
% only arrays that hold a run of this case are cancelled.
%
% Errors: DEcalioc:cancelCase:otherHost, :runFailed (a queue does not answer)

function done = cancelCase (Case)
  holder = lockHolder (Case.folder);
  if strcmp (holder.state, 'unknown')
    error ('DEcalioc:cancelCase:otherHost', ...
           ['process %d on %s works in this case. Call decalioc cancel ' ...
            'there: runs that are ended while it looks on are tried again. ' ...
            'If it is gone for sure, delete %s.'], holder.pid, holder.host, ...
           fullfile (Case.folder, 'decalioc.lock'));
  end
  runs = runsOfCase (Case);
  isOpen = ismember ({runs.state}, {'running', 'waiting'});
  done.octave = strcmp (holder.state, 'alive');
  if done.octave
    stopProcess (holder, Case.folder);
  end
  done.arrays = cancelArrays (Case, runs(isOpen));
  running = runs(strcmp ({runs.state}, 'running') & [runs.isCurrent]);
  cellfun (@endRun, {running.folder}, 'UniformOutput', false);
  for look = 1:50
    left = cellfun (@(f) nthargout (2, @runPids, f), {running.folder});
    if ~any (left)
      break
    end
    pause (0.2);
  end
  done.runs = sum (~left);
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
      error ('DEcalioc:cancelCase:runFailed', ...
             ['%s must cancel the jobs, got: %s. Try again when the queue ' ...
              'answers.'], queue.title, strtrim (text));
    end
    n = n + sum (isOurs);
  end
end

%!test
%! % nothing to end; a run whose Octave is this one
%! Case = newCase (standInCase (tempname ()));
%! done = cancelCase (Case);
%! assert (done, struct ('octave', false, 'runs', 0, 'arrays', 0));
%! writeAtomic (fullfile (Case.models(1).folder, 'runscript'), "sleep 100\n");
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(1);
%! folder = prepareRun (job, Case);
%! startRun (folder, Case.root);
%! while isempty (runPids (folder))
%!   pause (0.1);
%! end
%! assert (cancelCase (Case).runs, 1);
%! assert (readEndMark (folder).reason, 'killed');
%!test
%! % after a restart the number of a guard is the one of another program
%! Case = newCase (standInCase (tempname ()));
%! folder = prepareRun (newJobs (Case, [1, 2], [], 1, 'plan')(1), Case);
%! system (sprintf ('setsid sleep 1000 & echo $! > %s/other', folder));
%! other = str2double (fileread (fullfile (folder, 'other')));
%! writeAtomic (fullfile (folder, 'pid'), sprintf ("%d %d\n", other, other));
%! assert (cancelCase (Case).runs, 0);
%! pause (0.3);
%! assert (~isempty (processStart (other)));
%! kill (other, 9);
%!error id=DEcalioc:cancelCase:otherHost
%! Case = newCase (standInCase (tempname ()));
%! writeAtomic (fullfile (Case.folder, 'decalioc.lock'), "elsewhere 1 1\n");
%! cancelCase (Case);
%!test
%! % of two arrays in the queue, the one that holds a run of this case
%! place = tempname ();
%! mkdir (place);
%! writeAtomic (fullfile (place, 'scancel'), ...
%!              sprintf ("#!/bin/sh\necho \"$@\" > '%s/words'\n", place));
%! system (['chmod +x ', fullfile(place, 'scancel')]);
%! Case = newCase (standInCase (tempname ()));
%! folder = prepareRun (newJobs (Case, [1, 2], [], 1, 'plan')(1), Case);
%! for name = {'decalioc-a', 'decalioc-b'}
%!   batch = fullfile (Case.store, 'optim', '.slurm', name{1});
%!   mkdir (batch);
%!   writeAtomic (fullfile (batch, 'tasks'), sprintf ("k\t%s\n", folder));
%!   folder = '/some/other/run';
%! end
%! before = getenv ('PATH');
%! setenv ('PATH', [place, ':', before]);
%! done = cancelCase (Case);
%! setenv ('PATH', before);
%! assert (done.arrays, 1);
%! words = fileread (fullfile (place, 'words'));
%! assert (~isempty (strfind (words, '--jobname=decalioc-a')));
%! assert (isempty (strfind (words, 'decalioc-b')));
