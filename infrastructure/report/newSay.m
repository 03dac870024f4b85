% NEWSAY  Makes the function that speaks to the user.
%
% CALL: SAY = newSay (LOGFILE)
%
%   LOGFILE  path of the log (text)
%   SAY      handle SAY (TEXT [, CLASS]), see sayLine. At a terminal lines fit its
%            width, and are coloured unless NO_COLOR is set (no-color.org)

function say = newSay (logFile)
  screen = struct ('width', Inf, 'colour', false);
  if system ('test -t 1') == 0
    [~, size_] = system ('stty size 2> /dev/null < /dev/tty');
    screen.width = str2double (regexp (size_, '\d+\s*$', 'match', 'once'));
    if ~(screen.width >= 20)
      screen.width = 80;
    end
    screen.colour = isempty (getenv ('NO_COLOR'));
  end
  say = @(text, varargin) sayLine (text, logFile, screen, varargin{:});
end

%!test
%! % not a terminal, as in a test: as it is
%! file = tempname ();
%! say = newSay (file);
%! if system ('test -t 1') ~= 0
%!   assert (evalc ('say (repmat (''a '', 1, 99), ''bad'')'), [repmat('a ', 1, 99), "\n"]);
%! end
%! assert (nargin (say), -2);

% SPDX-License-Identifier: GPL-3.0-only
