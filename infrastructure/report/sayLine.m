% SAYLINE  Prints a line on the terminal and keeps it in the log file.
%
% CALL: sayLine (TEXT, LOGFILE)
%
%   TEXT     a line, or several with newlines between (text)
%   LOGFILE  path of the log (text); it is appended to

function sayLine (text, logFile)
  printf ('%s\n', text);
  fflush (stdout ());
  fid = fopen (logFile, 'a');           % a full disk stops no calibration
  if fid >= 0
    fprintf (fid, '%s\n', text);
    fclose (fid);
  end
end

%!test
%! file = tempname ();
%! evalc ("sayLine ('a', file); sayLine ('b', file);");
%! assert (fileread (file), "a\nb\n");
