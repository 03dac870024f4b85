% NAMEDFILES  Files outside a model that its scripts name.
%
% CALL: [FILES, OPEN, WRITTEN] = namedFiles (FOLDER, PLACE)
%
%   FOLDER  model folder (text); '', of runs of a table alone, names nothing
%   PLACE   path that a run folder of it has or would have (text): what relative
%           names are seen from
%   FILES   1 x n cell of paths, sorted: files that the runscript, an input
%           script (in.*) or a script that one of these names calls, reads or
%           includes, and programs on the PATH that a shell script calls
%   OPEN    1 x m cell of texts: what is named and not among FILES, since it is
%           a folder, too large (100 MB), or its name holds a variable that is
%           set nowhere here
%   WRITTEN 1 x w cell of paths outside the run folder that a run writes to (see
%           writtenOutside), which all runs share; none of them is among FILES
%
% Variables are those that the script sets to a plain text, or the environment;
% $PWD is PLACE, $(dirname "$0") the folder of the script. What a script writes
% (behind > and tee, the last word of cp and mv) is no input. Programs that
% every system has (commonPrograms), and liggghts, whose build has a place of
% its own in the key, are left out. Modules that a Python file imports from its
% own folder belong to it.

function [files, open, written] = namedFiles (folder, place)
  [files, open, written] = deal (cell (1, 0));
  if isempty (folder)
    return
  end
  inputs = glob (fullfile (regexprep (folder, '([][*?\\])', '\\$1'), 'in.*'))';
  queue = [{fullfile(folder, 'runscript')}, inputs];
  k = 0;
  while k < numel (queue)
    k = k + 1;
    [found, left, new] = namesIn (queue{k}, folder, place);
    written = unique ([written, new])(:)';
    queue = [queue, setdiff(found, queue)];
    open = [open, left];
  end
  written = written(~isBelowOne (written, written));
  isInside = strncmp (queue, [folder, '/'], numel (folder) + 1);
  files = setdiff (queue(~isInside & ~isBelowOne (queue, written)), written)(:)';
  sizes = cellfun (@(f) stat (f).size, files);
  open = setdiff ([open, files(sizes > 1e8)], written)(:)';
  files = files(sizes <= 1e8);
end

function yes = isBelowOne (files, folders)
  isOne = @(file) any (cellfun (@(f) strncmp (file, [f, '/'], numel (f) + 1), folders));
  yes = cellfun (isOne, files);
end

function [found, open, written] = namesIn (script, folder, place)
  [found, open, written] = deal (cell (1, 0));
  text = checkReadText (script);
  if isempty (text) || numel (text) > 1e5 || any (text == 0) || ...
     ~isempty (regexp (script, '^(/usr)?/s?bin/', 'once'))
    return                          % a mesh, a program, one of the system: no script
  end
  isShell = ~isempty (regexp (script, '(/runscript|\.sh)$', 'once')) || ...
            ~isempty (regexp (text, '^#![^\n]*sh\s', 'once'));
  [words, bases, filled] = scriptWords (text, script, folder, place);
  written = writtenOutside (filled, script, isShell, folder, place);
  commands = cell (1, 0);
  if isShell
    commands = commandsOf (text);
  end
  runs = [fileparts(fileparts (place)), '/'];
  isOpen = cellfun (@(w) any (w == '$'), words);
  isName = ~cellfun ('isempty', regexp (words, '\$\{?[A-Za-z_]\w*\}?/', 'once'));
  open = words(isOpen & isName & isShell);
  words = words(~isOpen);
  isCommand = ismember (words, commands);
  mayBe = isCommand | areThere (words, bases);
  for k = find (mayBe)
    file = fileOf (words{k}, bases, isCommand(k));
    if isempty (file)
      continue
    end
    if isfolder (file)
      open = [open, repmat({file}, 1, isWorthSaying (file, folder, place))];
    elseif ~strncmp (file, runs, numel (runs))
      found{end + 1} = file;
    end
  end
  found = [found, importsOf(text, script)];
end

% Most words are no files: all are looked up in one call.
function yes = areThere (words, bases)
  yes = strncmp (words, '/', 1) | ~cellfun ('isempty', strfind (words, '..'));
  isRelative = ~yes;
  for base = cellfun (@plainPath, bases, 'UniformOutput', false)
    pattern = regexprep (base{1}, '([][*?\\])', '\\$1');
    there = glob (strcat ([pattern, '/'], words));
    yes = yes | (isRelative & ismember (strcat ([base{1}, '/'], words), there));
  end
end

% Where W is; '' where nowhere, or where it is of no account.
function file = fileOf (w, bases, isCommand)
  file = '';
  if w(1) == '/'
    bases = {''};
  end
  for base = bases
    path = plainPath ([base{1}, '/', w]);
    if exist (path, 'file') && ~strcmp (path, '/')
      file = path;
      break
    end
  end
  if isempty (file) && isCommand && ~any (w == '/') && ...
     ~any (strcmp (w, [{'liggghts'}, commonPrograms()]))
    file = file_in_path (getenv ('PATH'), w);
    file = [file, ''];
  end
  % most words are no files
  if ~isempty (file) && isOfNoAccount (file)
    file = '';
  end
end

function yes = isOfNoAccount (file)
  yes = ~isempty (regexp (file, '^/(dev|proc|sys)/', 'once')) || ...
        (any (strcmp (fileparts (file), {'/bin', '/usr/bin'})) && ...
         any (strcmp (regexprep (file, '^.*/', ''), commonPrograms ())));
end

function yes = isWorthSaying (file, folder, place)
  common = '^/(usr|bin|lib|lib64|etc|var|tmp|dev|proc|sys|home|root)?(/[^/]*)?$';
  isBelow = @(a, b) strncmp ([a, '/'], [b, '/'], numel (b) + 1);
  yes = isempty (regexp (file, common, 'once')) && ...
        ~isBelow (place, file) && ~isBelow (folder, file) && ...
        ~isBelow (file, folder);
end

% First words of commands, and every word behind a program that starts another.
function names = commandsOf (text)
  parts = strtrim (regexp (text, '[^;&|()`\n]+', 'match'));
  names = cell (1, 0);
  starters = {'mpirun', 'mpiexec', 'srun', 'exec', 'nohup', 'time', 'nice', ...
              'env', 'stdbuf', 'timeout', 'setsid', 'xvfb-run', 'taskset', ...
              'then', 'do', 'else', 'if', 'while', '!', '{'};
  for part = parts
    words = regexp (part{1}, '[^\s"'']+', 'match');
    while ~isempty (words)
      names(end + 1) = words(1);
      isMore = any (strcmp (words{1}, starters)) || words{1}(1) == '-' || ...
               any (words{1} == '=') || any (isdigit (words{1}(1)));
      words = words(2:end * isMore);
    end
  end
end

function files = importsOf (text, script)
  files = cell (1, 0);
  if isempty (regexp (script, '\.py$', 'once'))
    return
  end
  names = regexp (text, '^\s*(?:from|import)\s+(\w+)', 'tokens', 'lineanchors');
  for name = [cell(1, 0), names{:}]
    file = fullfile (fileparts (script), [name{1}, '.py']);
    if isfile (file)
      files{end + 1} = file;
    end
  end
end

% Shells, text tools, interpreters, starters: programs of every system, that decide no result
% of a run. A change of one (an update of the system) asks for no new run.
function names = commonPrograms ()
  names = strsplit (['awk bash basename bc bunzip2 bzip2 cat chmod cmp cp ' ...
                     'csh cut dash date dc dd diff dirname du echo egrep ' ...
                     'env expr false find flock gawk grep gunzip gzip head ' ...
                     'hostname id join kill ksh ldd ln ls make mawk md5sum ' ...
                     'mkdir mktemp mpiexec mpirun mv nice nl nohup nproc ' ...
                     'numactl octave octave-cli od paste perl printf ps pwd ' ...
                     'python python2 python3 readlink realpath rm rmdir ' ...
                     'rsync scp sed seq setsid sh sha256sum sleep sort ' ...
                     'split srun stat stdbuf sync tac tail tar taskset tcsh ' ...
                     'tee test time timeout touch tr true tsort uname uniq ' ...
                     'unxz unzip wait wc which xargs xvfb-run xz yes zcat ' ...
                     'zip zsh'], ' ');
end

%!function [files, open] = named (script, more)
%!  place = tempname ();
%!  model = fullfile (place, 'case', 'DEMmodels', 'M');
%!  mkdir (model);
%!  put = @(name, text) writeAtomic (fullfile (place, name), text);
%!  put ('case/DEMmodels/M/runscript', strrep (script, '@', place));
%!  for file = more'
%!    [~, ~] = mkdir (fileparts (fullfile (place, file{1})));
%!    put (file{1}, strrep (file{2}, '@', place));
%!  end
%!  run = fullfile (place, 'case', 'optim', 'M', '0001');
%!  [files, open] = namedFiles (model, run);
%!  files = strrep (files, [place, '/'], '');
%!  open = strrep (open, [place, '/'], '');
%!endfunction
%!test
%! % nothing outside: the files of the model, common programs, output
%! inside = {'case/DEMmodels/M/go.sh', "awk 1 data.head > @/log\n"; ...
%!           'case/DEMmodels/M/data.head', "variable a equal 1\n"; ...
%!           'log', 'x'; 'all.txt', 'x'; 'last', 'x'};
%! [files, open] = named (["#!/bin/bash\n. ./go.sh # see @/log\n", ...
%!                         "liggghts -in in.M | tee @/log\n", ...
%!                         "echo end >> @/all.txt 2> /dev/null\n", ...
%!                         "cp out @/last\n"], inside);
%! assert ({files, open}, {cell(1, 0), cell(1, 0)});
%!test
%! % seen from the run folder, by full path, by variables, in another folder
%! more = {'solver.sh', "python3 \"$(dirname \"$0\")/tool/t.py\"\n"; ...
%!         'tool/t.py', "import helper\nfrom numpy import x\n"; ...
%!         'tool/helper.py', 'x = 1'; 'abs', 'x'; 'lib/a b', 'x'; ...
%!         'lib/run', 'x'; 'bin/dem', 'x'; 'here', 'x'};
%! assert (named ("bash ../../../../solver.sh\n", more), ...
%!         {'solver.sh', 'tool/helper.py', 'tool/t.py'});
%! assert (named ("exec @/abs < data.head\n", more), {'abs'});
%! assert (named ("LIB=@/lib\nexport BIN=@/bin\n$LIB/run; ${BIN}/dem\n", ...
%!                more), {'bin/dem', 'lib/run'});
%! assert (named ("${DEM:-@/bin/dem} x\n", more), {'bin/dem'});
%! assert (named ("cd ../../../../lib && ./run\n", more), {'lib/run'});
%! assert (named ("cat $PWD/../../../../here\n", more), {'here'});
%!test
%! % of an input script; what cannot be followed is said
%! more = {'case/DEMmodels/M/in.M', ["include @/common.in\n", ...
%!                                   "fix m all mesh file ../../../../a.stl\n"]; ...
%!         'common.in', "include ../../../../deep.in\n"; 'deep.in', 'x'; ...
%!         'a.stl', 'x'; 'data/x', 'y'};
%! [files, open] = named ("liggghts < in.M\ncp -r @/data .\n$NOWHERE/x\n", more);
%! assert (files, {'a.stl', 'common.in', 'deep.in'});
%! assert (open, {'$NOWHERE/x', 'data'});
%!test
%! % what a run writes and reads again is no input
%! more = {'work/out', 'x'; 'in', 'x'};
%! script = "d=${NOWHERE:-@/work}; mkdir -p $d; cat @/in > $d/out\ncp $d/out .\n";
%! [files, open] = named (script, more);
%! assert (files, {'in'});
%! assert (isempty (open));
%!test
%! % a program on the PATH
%! before = getenv ('PATH');
%! tidy = onCleanup (@() setenv ('PATH', before));
%! folder = emptyFolder ();
%! writeAtomic (fullfile (folder, 'my-dem'), 'x');
%! system (['chmod +x ', shellQuote(fullfile (folder, 'my-dem'))]);
%! setenv ('PATH', [folder, ':', before]);
%! for script = {"my-dem < in.M\n", "mpirun -np 4 my-dem -i x\n", ...
%!               "x=1 nice -n 5 my-dem\n", "if my-dem x; then echo; fi\n"}
%!   assert (named (script{1}, cell (0, 2)), {fullfile(folder, 'my-dem')});
%! end
%! assert (named ("echo my-dem\nawk 1 x | sort\n", cell (0, 2)), cell (1, 0));
%!test
%! [files, open] = namedFiles ('', tempname ());
%! assert ({files, open}, {cell(1, 0), cell(1, 0)});

% SPDX-License-Identifier: GPL-3.0-only
