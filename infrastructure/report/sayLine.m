% SAYLINE  Prints a line on the terminal and keeps it in the log file.
%
% CALL: sayLine (TEXT, LOGFILE [, SCREEN [, CLASS]])
%
%   TEXT     a line, or several with newlines between (text)
%   LOGFILE  path of the log (text); it is appended to
%   SCREEN   scalar struct width (longer lines go on in the next), colour
%            (logical), see newSay; default: neither
%   CLASS    'good', 'bad', 'open': the colour of a verdict; 'moving': the next
%            line takes its place on a terminal, and it is not kept

function sayLine (text, logFile, screen, class)
  if nargin < 3
    screen = struct ('width', Inf, 'colour', false);
  end
  if nargin < 4
    class = '';
  end
  isMoving = strcmp (class, 'moving') && isfinite (screen.width);
  printf ('%s', onScreen (text, screen, class, isMoving));
  fflush (stdout ());
  if isMoving
    return
  end
  fid = fopen (logFile, 'a');           % a full disk stops no calibration
  if fid >= 0
    fprintf (fid, '%s\n', text);
    fclose (fid);
  end
end

function text = onScreen (text, screen, class, isMoving)
  if isMoving
    text = sprintf ("\r\033[K%s\r", text(1:min (end, screen.width - 1)));
    return
  elseif isfinite (screen.width) && numel (text) > screen.width
    indent = regexp (text, '^ *', 'match', 'once');
    lines = wrapText (text(numel (indent) + 1:end), screen.width - numel (indent) - 2);
    text = strjoin ([{[indent, lines{1}]}, strcat({[indent, '  ']}, lines(2:end))], "\n");
  end
  colours = struct ('good', 32, 'bad', 31, 'open', 33);
  if screen.colour && isfield (colours, class)
    text = sprintf ("\033[1;%dm%s\033[0m", colours.(class), text);
  end
  if isfinite (screen.width)
    text = ["\r\033[K", text];          % over what moves
  end
  text = [text, "\n"];
end

%!test
%! file = tempname ();
%! evalc ("sayLine ('a', file); sayLine ('b', file);");
%! assert (fileread (file), "a\nb\n");
%!test
%! % at a terminal: lines fit, a verdict has its colour, progress leaves no trace
%! file = tempname ();
%! screen = struct ('width', 12, 'colour', true);
%! text = evalc ("sayLine ('  abc def ghi jkl', file, screen, 'bad')");
%! assert (text, "\r\033[K\033[1;31m  abc def\n    ghi jkl\033[0m\n");
%! text = evalc ("sayLine ('1 of 2', file, screen, 'moving')");
%! assert (text, "\r\033[K1 of 2\r");
%! assert (fileread (file), "  abc def ghi jkl\n");

% SPDX-License-Identifier: GPL-3.0-only
