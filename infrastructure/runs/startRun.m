% STARTRUN  Starts the simulation of a prepared run and does not wait for it.
%
% CALL: startRun (FOLDER, ROOT, OWNER)
%
%   FOLDER  folder of the run (text)
%   ROOT    folder of the toolbox (text)
%   OWNER   process number of the Octave that the run is for (default: this one)
%
% The run is watched by guard.sh, which ends it when OWNER is gone, and which
% writes end.mark.
%
% Errors: DEcalioc:startRun:runFailed
%
% See also: prepareRun, collectRuns, endRun

function startRun (folder, root, owner)
  if nargin < 3
    owner = getpid ();
  end
  guard = fullfile (root, 'infrastructure', 'runs', 'guard.sh');
  command = sprintf ('setsid bash %s %s %d > /dev/null 2>&1 < /dev/null &', ...
                     shellQuote (guard), shellQuote (folder), owner);
  status = system (command);
  if status ~= 0
    error ('DEcalioc:startRun:runFailed', ...
           'startRun: the shell must start %s, it gave status %d.', ...
           guard, status);
  end
end
