% SCRIPTPOST  A program that makes the results of what LIGGGHTS has written.
%
% CALL: POST = scriptPost (FILE, FOUND)
%
%   FILE   path of decalioc new --post ('': none)
%   FOUND  see scriptFiles: of the script behind which it is called, in the same
%          folder
%   POST   scalar struct: file (full path), files (1 x n cell of paths: itself, and
%          modules and files beside it that it names and no run writes), program
%          (words of bash that start it)
%
% A Python, R, Perl, Octave or shell program by its ending; any other one by its
% first line #!.
%
% Errors: DEcalioc:scriptPost:missingFile, :badValue

function post = scriptPost (file, found)
  post = struct ('file', '', 'files', {cell(1, 0)}, 'program', '');
  if isempty (file)
    return
  elseif ~isfile (file)
    error ('DEcalioc:scriptPost:missingFile', ...
           ['--post must name a program that makes the results of a run, got %s: ' ...
            'no such file.'], file);
  end
  text = readText (file);
  post.file = plainPath (make_absolute_filename (file));
  post.program = programOf (post.file, text);
  if strcmp (post.program, 'bash') && any (fileread (file) == "\r")
    error ('DEcalioc:scriptPost:badValue', ...
           ['--post: %s must have the line ends of Linux, got those of Windows, which ' ...
            'bash takes for letters of names. sed -i ''s/\r$//'' FILE changes them.'], file);
  end
  post.files = unique ([{post.file}, besideIt(fileparts (post.file), text, found)]);
end

function program = programOf (file, text)
  known = {'.py', 'python3'; '.r', 'Rscript --vanilla'; '.pl', 'perl'; ...
           '.sh', 'bash'; '.m', 'octave-cli --no-gui --norc -q'};
  [~, name, ending] = fileparts (file);
  first = regexp (text, '^#!\s*([^\n'']+)', 'tokens', 'once');
  k = find (strcmp (lower (ending), known(:, 1)), 1);
  if ~isempty (k)
    program = known{k, 2};
  elseif ~isempty (first)
    program = strtrim (first{1});
  else
    error ('DEcalioc:scriptPost:badValue', ...
           ['--post must name a program by its ending (%s), or one with a first ' ...
            'line #!, got %s%s.'], strjoin (known(:, 1)', ', '), name, ending);
  end
end

% Modules of Python, and names in quotes; not what a trial by hand has left, which
% the script writes, or the program itself (open ('x', 'w')).
function paths = besideIt (folder, text, found)
  modules = regexp (text, '^[ \t]*(?:import|from)[ \t]+([\w., ]+?)(?:[ \t]+(?:import|as)\>|$)', ...
                    'tokens', 'lineanchors');
  modules = strsplit (strjoin ([cell(1, 0), modules{:}], ','), ',');
  names = regexp (text, '["'']([^"''\n*]{1,200})["''](?!\s*,\s*["'']w)', 'tokens');
  names = [strcat(strrep (strtrim (modules), '.', '/'), '.py'), names{:}];
  paths = cellfun (@(name) plainPath ([folder, '/', name]), names, ...
                   'UniformOutput', false);
  paths = paths(isfile (paths));
  % a folder that runs write to holds what they have left
  written = [cell(1, 0), cellfun(@fileparts, found.written, 'UniformOutput', false)];
  isLeft = ismember (paths, found.written) | ...
           (ismember (cellfun (@fileparts, paths, 'UniformOutput', false), written) & ...
            ~strcmp (cellfun (@fileparts, paths, 'UniformOutput', false), folder));
  paths = paths(~isLeft);
end

%!shared folder, put, found
%! [folder, put] = emptyFolder ();
%! found = struct ('written', {{fullfile(folder, 'out', 'flow.txt')}});
%! [~, ~] = mkdir (fullfile (folder, 'out'));
%! cellfun (@(name) put (name, 'x'), {'own.py', 'cal.csv', 'plot.png', 'out/flow.txt', ...
%!                                    'out/d.1'});
%!test
%! mkdir (fullfile (folder, 'lib'));
%! put ('lib/tools.py', 'x');
%! put ('post.py', ["import math, own\nfrom lib.tools import x\nfrom sys import argv\n", ...
%!                  "open('cal.csv')\nopen(\"out/flow.txt\"); open('out/d.1')\n", ...
%!                  "open('plot.png', 'w')\n"]);
%! post = scriptPost (fullfile (folder, 'post.py'), found);
%! assert (post.program, 'python3');
%! assert (post.files, fullfile (folder, {'cal.csv', 'lib/tools.py', 'own.py', 'post.py'}));
%! put ('post', "#!/usr/bin/env perl\n");
%! assert (scriptPost (fullfile (folder, 'post'), found).program, '/usr/bin/env perl');
%! assert (scriptPost ('', found).files, cell (1, 0));
%!error id=DEcalioc:scriptPost:missingFile scriptPost ('/nowhere/post.py', found)
%!test
%! put ('post.sh', "echo angle 24 > result.txt\r\n");
%! fail ('scriptPost (fullfile (folder, ''post.sh''), found)', 'line ends of Linux');
%!error id=DEcalioc:scriptPost:badValue scriptPost (fullfile (folder, 'cal.csv'), found)

% SPDX-License-Identifier: GPL-3.0-only
