% STARTSLEEP  A process that does nothing, in a session of its own.
%
% CALL: [PID, MARK] = startSleep (SECONDS)
%
%   SECONDS  that it lives;  PID, MARK  see processStart
%
% It is the program sleep, and no shell any more, when this returns.

function [pid, mark] = startSleep (seconds)
  [~, pid] = system (sprintf ('setsid sleep %d > /dev/null 2>&1 & echo $!', ...
                              seconds));
  pid = str2double (pid);
  waitUntil (@() strcmp (commandOf (pid), 'sleep'));
  [~, mark] = processStart (pid);
end

function name = commandOf (pid)
  [~, mark] = processStart (pid);
  words = [strsplit(mark, ' '), {'', '', ''}];
  name = words{3};
end

%!test
%! [pid, mark] = startSleep (50);
%! assert (~isempty (strfind (mark, ' sleep ')));
%! kill (pid, 9);

% SPDX-License-Identifier: GPL-3.0-only
