% STARTASIDE  Starts a command of decalioc that goes on beside the test.
%
% CALL: PID = startAside (FOLDER, WORDS)
%
%   FOLDER  where the file said takes what it says
%   WORDS   of the command line, for the shell
%   PID     of its Octave, which leads a process group of its own
%
% See also: startCommand

function pid = startAside (folder, words)
  root = fileparts (fileparts (which ('startProgram')));
  program = shellQuote (fullfile (root, 'bin', 'decalioc'));
  [~, text] = system (sprintf (['setsid %s %s > %s 2>&1 < /dev/null & ' ...
                                'echo $!'], program, words, ...
                               shellQuote (fullfile (folder, 'said'))));
  pid = str2double (text);
end

%!test
%! folder = emptyFolder ();
%! pid = startAside (folder, 'version');
%! waitUntil (@() isempty (processStart (pid)));
%! assert (~isempty (fileread (fullfile (folder, 'said'))));

% SPDX-License-Identifier: GPL-3.0-only
