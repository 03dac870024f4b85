% RUNPIDS  Process numbers of a run: its guard and its session.
%
% CALL: PIDS = runPids (FOLDER)
%
%   FOLDER  folder of the run (text)
%   PIDS    1 x 2, or empty where the guard has not started yet
%
% See also: startRun, endRun

function pids = runPids (folder)
  pids = [];
  fid = fopen (fullfile (folder, 'pid'), 'r');
  if fid >= 0
    pids = fscanf (fid, '%d', [1, 2]);
    fclose (fid);
  end
end

%!assert (isempty (runPids ('/nowhere')))
