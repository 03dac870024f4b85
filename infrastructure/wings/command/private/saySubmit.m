% SAYSUBMIT  Has the main program itself work as a job of the queue.
%
% CALL: STATUS = saySubmit (ROOT, FOLDER, ARGS)
%
%   ROOT    folder of the toolbox (text)
%   FOLDER  case folder (text)
%   ARGS    cell of texts: '--diagnose' the diagnosis, not the calibration;
%           '--minutes' N, time that the job may take (default 1440)
%   STATUS  0
%
% The job has one CPU on one node and submits the runs from there, so the node
% needs Octave and the programs of the queue. It has the environment of this
% call. What it says is in FOLDER/submitted/said.txt, its name in submitted/job.
%
% Errors: DEcalioc:saySubmit:badExecutor  the runs go to no queue
%         DEcalioc:saySubmit:badValue     of --minutes
%         DEcalioc:saySubmit:inUse        somebody works in the case, or will
%         DEcalioc:saySubmit:missingFile  no such queue on this machine
%         DEcalioc:saySubmit:submitRefused
%         those of loadCase and withEffects

function status = saySubmit (root, folder, args)
  options = commandOptions (args, struct ('diagnose', 'flag', ...
                                          'minutes', 'one'));
  minutes = minutesOf (options.minutes);
  useLiggghts (root);
  Case = withEffects (loadCase (root, folder));
  queue = describeExecutor (Case.options.executor);
  if queue.isHere
    error ('DEcalioc:saySubmit:badExecutor', ...
           ['submit needs runs that go to a queue, got Input.executor = ' ...
            '''%s''. Set ''slurm'' or ''gridengine'' in loadInput.m, or ' ...
            'start decalioc run here.'], Case.options.executor);
  end
  [~, fault] = queue.start ();
  if ~isempty (fault)
    error ('DEcalioc:saySubmit:missingFile', ...
           ['submit: this machine must be one of a cluster with %s, got: ' ...
            '%s. Call it on a machine where jobs can be submitted.'], ...
           queue.title, fault);
  end
  keepOut (folder);
  words = {'run', 'diagnose'};
  command = words{1 + options.diagnose};
  name = send (Case, queue, command, minutes);
  printf (['submitted  decalioc %s as the job %s on %s, for at most %d ' ...
           'minutes. This terminal may be closed.\n'], command, name, ...
          queue.title, minutes);
  printf ('           it says: %s\n', fullfile (folder, 'submitted', ...
                                                'said.txt'));
  printf (['           decalioc status shows how far it is, decalioc cancel ' ...
           'ends it; submitted again, it goes on where it stopped.\n']);
  status = 0;
end

function minutes = minutesOf (text)
  minutes = 24 * 60;
  if ~isempty (text)
    minutes = str2double (text);
  end
  if ~(minutes >= 1 && minutes <= 1e7 && minutes == round (minutes))
    error ('DEcalioc:saySubmit:badValue', ...
           ['--minutes must be a whole number from 1, got %s. Give the time ' ...
            'that the job may take, 2880 for two days.'], text);
  end
end

% Two jobs of one case would wait for each other's lock.
function keepOut (folder)
  [job, state] = submittedJob (folder);
  holder = lockHolder (folder);
  who = '';
  if any (strcmp (state, {'waiting', 'running', 'unknown'}))
    who = sprintf ('the job %s (%s)', job.name, state);
  elseif any (strcmp (holder.state, {'alive', 'unknown'}))
    who = sprintf ('process %d on %s', holder.pid, holder.host);
  end
  if ~isempty (who)
    error ('DEcalioc:saySubmit:inUse', ...
           ['submit needs a case in which nobody works, got %s. decalioc ' ...
            'status shows how far it is, decalioc cancel ends it.'], who);
  end
end

function name = send (Case, queue, command, minutes)
  place = fullfile (Case.folder, 'submitted');
  [~, ~] = mkdir (place);
  name = ['decalioc-main-', ...
          hash('md5', sprintf ('%s %.17g', Case.folder, time ()))(1:8)];
  batch = struct ('name', name, 'path', place, 'n', 1, 'cpu', 1, ...
                  'minutes', minutes);
  % written down before: a queue may take a job without saying so
  writeAtomic (fullfile (place, 'job'), ...
               sprintf ("%s %s\n", Case.options.executor, name));
  script = fullfile (Case.root, 'infrastructure', 'runs', 'executors', 'queues', ...
                     'mainTask.sh');
  task = {script, fullfile(Case.root, 'bin', 'decalioc'), command, Case.folder};
  [verdict, text] = queue.send (batch, queue.options (Case.options), task);
  if ~strcmp (verdict, 'sent')
    error ('DEcalioc:saySubmit:submitRefused', ...
           ['submit: %s must accept one job of %d minutes, got: %s. Correct ' ...
            'Input.%s or --minutes, or try again when the queue answers.'], ...
           queue.title, minutes, text, queue.name);
  end
end

%!function folder = queueCase ()
%!  folder = standInCase (tempname ()).folder;
%!  writeLoadInput (folder, ['Input.executor = ''slurm''; ', ...
%!                           'Input.slurm.partition = ''long'';']);
%!endfunction
%!test
%! % what is submitted; a second time it is not; cancelled, it is gone
%! folder = queueCase ();
%! master = slurmFake ('echo "MaxArraySize = 1001"', 'true', ...
%!                     {'scontrol', 'scancel'});
%! words = shellQuote (fullfile (folder, 'words'));
%! tidy = slurmFake (['printf "%s\n" "$@" > ', words], ...
%!                   ['[ ! -e ', words, ' ] || echo "$(cut -d" " -f2 ', ...
%!                    shellQuote(fullfile (folder, 'submitted', 'job')), ...
%!                    ')|1|PENDING|None"']);
%! [status, text] = startCommand (folder, 'submit --minutes 2880');
%! assert (status == 0, text);
%! said = strsplit (fileread (fullfile (folder, 'words')), "\n");
%! assert (all (ismember ({'--partition=long', '--time=2880', '--ntasks=1', ...
%!                         '--array=1-1', 'run', folder}, said)));
%! name = submittedJob (folder).name;
%! assert (any (strcmp (['--job-name=', name], said)));
%! [status, text] = startCommand (folder, 'submit');
%! assert (status, 1);
%! assert (~isempty (strfind (text, [name, ' (waiting)'])), text);
%!test
%! % refused; no queue; a wrong time
%! folder = queueCase ();
%! master = slurmFake ('echo "MaxArraySize = 1001"', 'true', ...
%!                     {'scontrol', 'scancel'});
%! tidy = slurmFake ('echo "invalid partition"; exit 1', 'true');
%! [status, text] = startCommand (folder, 'submit');
%! assert (status, 1);
%! assert (~isempty (strfind (text, 'got: invalid partition')), text);
%! [status, text] = startCommand (folder, 'submit --minutes=soon');
%! assert (status == 1 && ~isempty (strfind (text, 'got soon')), text);
%! clear tidy
%! writeLoadInput (folder);
%! [status, text] = startCommand (folder, 'submit');
%! assert (status == 1 && ~isempty (strfind (text, 'Input.executor')), text);

% SPDX-License-Identifier: GPL-3.0-only
