% FAULTTRIAL  Kills a process at a random moment, starts again, compares.
%
% CALL: faultTrial (FOLDER, TARGET, DELAY, ANSWER)
%
%   FOLDER  folder to be made for the case (text)
%   TARGET  'octave', 'worker', 'guard', 'simulation' or 'mpirun'
%   DELAY   seconds after the start at which it is killed with signal 9
%   ANSWER  text of answer.csv of an undisturbed start
%
% Asserts that the answer is the same to the last digit, that no simulation is
% left without its Octave, and that no finished run was repeated.
%
% See also: faultProgram, faultCase

function faultTrial (folder, target, delay, answer)
  faultCase (folder);
  [pid, log] = launch (folder);
  pause (delay);
  killOne (target, pid, folder);
  waitFor (pid);
  finished = finishedRuns (folder);
  for attempt = 1:3
    if isfile (fullfile (folder, 'answer.csv'))
      break
    end
    [pid, log] = launch (folder);
    waitFor (pid);
  end
  assert (isfile (fullfile (folder, 'answer.csv')), fileread (log));
  if ~strcmp (fileread (fullfile (folder, 'answer.csv')), answer)
    error ('DEcalioc:faultTrial:otherAnswer', ...
           'faultTrial: after the death of %s the answer differs.\n%s', ...
           target, allRecords (folder));
  end
  assert (noneRunning (folder));
  [~, keys] = finishedRuns (folder);
  assert (numel (unique (keys)), numel (keys));
  assert (all (ismember (finished, finishedRuns (folder))));
  confirm_recursive_rmdir (false, 'local');
  rmdir (folder, 's');
end

function [pid, log] = launch (folder)
  program = fullfile (fileparts (mfilename ('fullpath')), 'faultProgram.m');
  log = fullfile (folder, 'log');
  [~, text] = system (sprintf (['cd %s && setsid octave-cli --no-history ', ...
                                '%s > log 2>&1 < /dev/null & echo $!'], ...
                               shellQuote (folder), shellQuote (program)));
  pid = str2double (text);
end

function waitFor (pid)
  waitUntil (@() ~isfolder (sprintf ('/proc/%d', pid)) || isZombie (pid), 900);
end

function yes = isZombie (pid)
  [~, text] = system (sprintf ('ps -o stat= -p %d', pid));
  yes = any (text == 'Z');
end

% Processes of this trial only: those below its Octave or in its run folders.
function killOne (target, pid, folder)
  inside = insideOf (folder);
  switch target
    case 'octave'
      pids = pid;
    case 'worker'
      pids = listed (sprintf ('pgrep -P %d -f rfeval', pid));
    case 'guard'
      pids = listed (sprintf ('pgrep -f %s', ...
                              shellQuote (['guard.sh ', folder])));
    case 'simulation'
      pids = intersect (listed (inside), listed ('pgrep -x "sleep|awk"'));
    case 'mpirun'
      pids = intersect (listed (inside), listed ('pgrep -x mpirun'));
  end
  if ~isempty (pids)
    system (sprintf ('kill -9 %d 2> /dev/null', pids(randi (numel (pids)))));
  end
end

function pids = listed (command)
  [~, text] = system ([command, ' 2> /dev/null']);
  pids = sscanf (text, '%d')';
end

function [folders, keys] = finishedRuns (folder)
  files = glob (fullfile (folder, 'optim', '*', '*', 'record.json'));
  folders = {};
  keys = {};
  for i = 1:numel (files)
    record = readRecord (files{i});
    if ~isempty (record) && strcmp (record.status, 'ok')
      folders{end + 1} = files{i};
      keys{end + 1} = record.key;
    end
  end
end

% What each run became, and what it left behind where it failed.
function text = allRecords (folder)
  [~, text] = system (sprintf (['cd %s/optim && tail -n +1 ', ...
                                '*/*/record.json */*/end.mark */*/std*'], ...
                               shellQuote (folder)));
end

% Guards look once a second whether their Octave is alive.
function none = noneRunning (folder)
  for i = 1:60
    [~, text] = system (insideOf ([folder, '/optim']));
    none = isempty (text);
    if none
      return
    end
    pause (0.1);
  end
end

% Shell text that prints the processes whose working folder is in a folder.
function command = insideOf (folder)
  command = ['for p in /proc/[0-9]*; do case $(readlink $p/cwd) in ', ...
             shellQuote(folder), '/*) echo ${p#/proc/};; esac; done ', ...
             '2> /dev/null'];
end

% SPDX-License-Identifier: GPL-3.0-only
