% ASUSER  What the shell carries out as one of the users of twoUsers.
%
% CALL: [STATUS, OUT] = asUser (USER, WORDS)   carried out
%       USER = asUser (USER)                   decalioc run, in the background
%
%   USER    scalar struct, see userCase; pid is then the number of its session,
%           starts that of the log (USER.home/log1 ...); the file status there
%           says how it has ended
%   WORDS   arguments of decalioc (text)
%   STATUS  exit status;  OUT  what was printed (text)
%
% Root becomes the user (setpriv); another caller stays who he is.
%
% See also: userCase, hitUser

function [status, out] = asUser (user, words)
  if nargin == 1
    status = started (user);
  else
    [status, out] = system (textOf (user, '', [words, ' 2>&1 < /dev/null']));
  end
end

function text = textOf (user, apart, words)
  who = '';
  if geteuid () == 0
    who = sprintf ('setpriv --reuid=%d --regid=2000 --clear-groups ', user.uid);
  end
  program = fullfile (fileparts (fileparts (which ('startToolbox'))), 'bin', ...
                      'decalioc');
  text = sprintf ('cd %s && exec env HOME=%s %s%sbash -c %s', ...
                  shellQuote (user.folder), shellQuote (user.home), who, ...
                  apart, shellQuote (['umask 002; ', shellQuote(program), ...
                                      ' ', words]));
end

% In a session of its own; how it ended is in the file status.
function user = started (user)
  user.starts = user.starts + 1;
  [~, ~] = unlink (fullfile (user.home, 'status'));
  words = sprintf (['run > ../log%d 2>&1 < /dev/null; ' ...
                    'echo $? > ../status'], user.starts);
  [~, pid] = system (['(', textOf(user, 'setsid ', words), ...
                      ') > /dev/null 2>&1 < /dev/null & echo $!']);
  user.pid = str2double (pid);
end
