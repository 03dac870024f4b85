% DRAWSVG  Draws the figures of a page, all with one start of gnuplot.
%
% CALL: TEXTS = drawSvg (LINES, N)
%
%   LINES  1 x l cell of lines for gnuplot, which write the files 1.svg to N.svg
%   TEXTS  1 x N cell, what they hold
%
% The files lie in the folder of temporary files for as long as it takes. Where
% that is full gnuplot writes half a figure and says nothing.
%
% Errors: DEcalioc:drawSvg:noSpace, DEcalioc:drawSvg:runFailed

function texts = drawSvg (lines, n)
  folder = privateFolder ();
  tidy = onCleanup (@() removeFolder (folder));
  program = [strjoin(lines, "\n"), "\nunset output\n"];
  hasRoom = written (folder, 'all.gp', program);
  [status, said] = system (['cd ', shellQuote(folder), ' && gnuplot all.gp ', ...
                            '2>&1 < /dev/null']);
  texts = arrayfun (@(k) readText (fullfile (folder, sprintf ('%d.svg', k))), ...
                    1:n, 'UniformOutput', false);
  isWhole = ~cellfun (@isempty, regexp (texts, '</svg>\s*$', 'once'));
  if status == 0 && all (isWhole)
    return
  end
  if ~hasRoom || ~written (folder, 'room', blanks (1e6))
    error ('DEcalioc:drawSvg:noSpace', ...
           ['drawSvg: the folder of temporary files, %s, must have a MB of ' ...
            'room for the figures, got: it is full. Free some space there, ' ...
            'or set TMPDIR to a folder on another disk.'], tempdir ());
  end
  error ('DEcalioc:drawSvg:runFailed', ...
         ['drawSvg: gnuplot must draw the figures, got: %s. On Debian: ' ...
          'apt-get install gnuplot-nox.'], strtrim (said));
end

function yes = written (folder, name, text)
  yes = true;
  try
    writeAtomic (fullfile (folder, name), text, false);
  catch
    yes = false;
  end
end

function removeFolder (folder)
  confirm_recursive_rmdir (false, 'local');
  rmdir (folder, 's');
end

%!shared lines, hasGnuplot
%! hasGnuplot = ! isempty (file_in_path (getenv ('PATH'), 'gnuplot'));
%! lines = {'set terminal svg', 'set output ''1.svg''', 'plot sin (x)', ...
%!          'set output ''2.svg''', 'plot cos (x)'};
%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'gnuplot'))
%! texts = drawSvg (lines, 2);
%! assert (strncmp (texts, '<?xml', 5), [true, true]);
%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'gnuplot'))
%! % a figure that was not drawn
%! caught = '';
%! try
%!   drawSvg (lines, 3);
%! catch err
%!   caught = err.identifier;
%! end
%! assert (caught, 'DEcalioc:drawSvg:runFailed');
