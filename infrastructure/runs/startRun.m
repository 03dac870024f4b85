% STARTRUN  Starts the simulation of a prepared run and does not wait for it.
%
% CALL: startRun (FOLDER, ROOT)
%
%   FOLDER  folder of the run (text)
%   ROOT    folder of the toolbox (text)
%
% The run is watched by guard.sh, which ends it when this Octave is gone, and
% which writes end.mark.
%
% Errors: DEcalioc:startRun:runFailed
%
% See also: prepareRun, collectRuns, endRun

function startRun (folder, root)
  guard = fullfile (root, 'infrastructure', 'runs', 'guard.sh');
  command = sprintf ('setsid bash %s %s %d > /dev/null 2>&1 < /dev/null &', ...
                     shellQuote (guard), shellQuote (folder), getpid ());
  status = system (command);
  if status ~= 0
    error ('DEcalioc:startRun:runFailed', ...
           'startRun: the shell must start %s, it gave status %d.', ...
           guard, status);
  end
end
