% ENDRUN  Ends a simulation that is under way, with all it has started.
%
% CALL: endRun (FOLDER)
%
%   FOLDER  folder of the run (text)
%
% See also: startRun, executeLocal

function endRun (folder)
  pids = runPids (folder);
  if numel (pids) == 2
    system (sprintf ('kill -TERM %d 2> /dev/null', pids(1)));
  end
end
