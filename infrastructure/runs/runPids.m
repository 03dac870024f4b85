% RUNPIDS  Process numbers of a run: its guard and its session.
%
% CALL: [PIDS, ISALIVE, ISHERE] = runPids (FOLDER)
%
%   FOLDER   folder of the run (text)
%   PIDS     1 x 2, or empty where the guard has not started yet
%   ISALIVE  the guard lives on this machine: start, boot and command of the
%            process are those that the guard has noted of itself
%   ISHERE   the guard has run on this machine, since it was started

function [pids, isAlive, isHere] = runPids (folder)
  pids = [];
  isAlive = false;
  isHere = false;
  fid = fopen (fullfile (folder, 'pid'), 'r');
  if fid >= 0
    pids = fscanf (fid, '%d', [1, 2]);
    mark = strtrim (fread (fid, Inf, 'uint8=>char')');
    fclose (fid);
  end
  if numel (pids) == 2
    [~, now] = processStart (pids(1));
    isAlive = ~isempty (mark) && strcmp (mark, now);
    [~, ours] = processStart (getpid ());
    isHere = ~isempty (mark) && ...
             isequal (strsplit (mark, ' ')(2:end - 1), ...
                      strsplit (ours, ' ')(2:end - 1));
  end
end

%!assert (isempty (runPids ('/nowhere')))
%!test
%! % a number alone, another start, another boot, another command
%! folder = tempname ();
%! mkdir (folder);
%! [~, mark] = processStart (getpid ());
%! boot = strsplit (mark, ' '){2};
%! for text = {'', ['1', mark], strrep(mark, boot, fliplr (boot)), ...
%!             [mark, 'x'], mark}
%!   writeAtomic (fullfile (folder, 'pid'), ...
%!                sprintf ("%d 77 %s\n", getpid (), text{1}));
%!   [pids, isAlive] = runPids (folder);
%!   assert ({pids, isAlive}, {[getpid(), 77], strcmp(text{1}, mark)});
%! end
