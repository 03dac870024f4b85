% RUNPIDS  Process numbers of a run: its guard and its session.
%
% CALL: [PIDS, ISALIVE, ISHERE, ISGONE] = runPids (FOLDER)
%
%   FOLDER   folder of the run (text)
%   PIDS     1 x 2, or empty where the guard has not started yet
%   ISALIVE  the guard lives on this machine: start, boot and command of the
%            process are those that the guard has noted of itself
%   ISHERE   the guard has run on this machine, since it was started, and not in
%            another container
%   ISGONE   the guard is gone for sure, where it has run on this machine; false
%            where it cannot be seen from here (another container)

function [pids, isAlive, isHere, isGone] = runPids (folder)
  pids = [];
  isAlive = false;
  isHere = false;
  isGone = false;
  fid = fopen (fullfile (folder, 'pid'), 'r');
  if fid >= 0
    pids = fscanf (fid, '%d', [1, 2]);
    mark = strtrim (fread (fid, Inf, 'uint8=>char')');
    fclose (fid);
  end
  if numel (pids) == 2
    [isAlive, isHere, isGone] = guardOf (pids(1), ostrsplit (mark, ' '));
  end
end

% MARK  words of processStart: start, boot, command, namespace
function [isAlive, isHere, isGone] = guardOf (pid, mark)
  first = '4026531836';                     % PROC_PID_INIT_INO, see lockHolder
  [~, now, isSure] = processStart (pid);
  [~, own] = processStart (getpid ());
  [now, own] = deal (ostrsplit (now, ' '), ostrsplit (own, ' '));
  isWhole = numel (mark) == 4 && numel (own) == 4;
  isAlive = isWhole && isequal (mark, now);
  isHere = isWhole && all (strcmp (mark([2, 4]), own([2, 4])));
  isBefore = isWhole && ~strcmp (mark{2}, own{2}) && ...
             all (strcmp ({mark{4}, own{4}}, first));
  isGone = ~isAlive && (isHere && isSure || isBefore);
end

%!assert (isempty (runPids ('/nowhere')))
%!test
%! % a number alone, another start, another boot, another command
%! folder = emptyFolder ();
%! [~, mark] = processStart (getpid ());
%! boot = strsplit (mark, ' '){2};
%! for text = {'', ['1', mark], strrep(mark, boot, fliplr (boot)), ...
%!             [mark, 'x'], mark}
%!   writeAtomic (fullfile (folder, 'pid'), ...
%!                sprintf ("%d 77 %s\n", getpid (), text{1}));
%!   [pids, isAlive] = runPids (folder);
%!   assert ({pids, isAlive}, {[getpid(), 77], strcmp(text{1}, mark)});
%! end
%!test
%! % another container: not alive here, not gone; before a restart it is gone
%! folder = emptyFolder ();
%! [~, mark] = processStart (getpid ());
%! words = strsplit (mark, ' ');
%! boot = fliplr (words{2});
%! isFirst = strcmp (words{4}, '4026531836');
%! for given = {{words{1}, words{2}, 'mail', words{4}}, [0, 1, 1]; ...
%!              [words(1:3), {'77'}], [0, 0, 0]; ...
%!              words(1:3), [0, 0, 0]; ...
%!              {words{1}, boot, words{3}, '77'}, [0, 0, 0]; ...
%!              {words{1}, boot, words{3}, words{4}}, [0, 0, isFirst]}'
%!   writeAtomic (fullfile (folder, 'pid'), ...
%!                sprintf ("%d 77 %s\n", getpid (), strjoin (given{1}, ' ')));
%!   [~, isAlive, isHere, isGone] = runPids (folder);
%!   assert (isequal ([isAlive, isHere, isGone], given{2}), ...
%!           strjoin (given{1}, ' '));
%! end

% SPDX-License-Identifier: GPL-3.0-only
