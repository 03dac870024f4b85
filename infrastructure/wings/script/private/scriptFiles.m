% SCRIPTFILES  What a LIGGGHTS script names: files, and variables.
%
% CALL: FOUND = scriptFiles (SCRIPT, START, GIVEN)
%
%   SCRIPT  path of the script (text)
%   START   folder in which LIGGGHTS is started, which names are relative to
%           (text, default: the folder of SCRIPT)
%   GIVEN   scalar struct of numbers that are handed over by -var (default none)
%   FOUND   scalar struct
%     scripts    1 x s cell of paths: SCRIPT, and what it includes or jumps to
%     files      1 x n cell of paths that words of these scripts lead to,
%                without SCRIPT and without what is written before it is read;
%                files named by a full path, which stay where they are, are not
%                among them
%     variables  scalar struct: single numbers that "variable NAME index VALUE"
%                declares; the first one of a name counts, as in LIGGGHTS. A list
%                of values is the script's own loop and no variable of a model
%     missing    1 x m cell of texts: files that are read and are not there
%     open       1 x k cell of texts: names whose variables are not known before
%                a run
%     written    1 x w cell of paths that the scripts write to
%     text       of all scripts;  commands  of it, see scriptCommands
%
% Variables in names are filled in: of style index and loop with each of their
% values, string, equal with a number, getenv. "shell cd" is followed.
%
% Errors: DEcalioc:scriptFiles:missingFile

function found = scriptFiles (script, start, given)
  if ~isfile (script)
    error ('DEcalioc:scriptFiles:missingFile', ...
           '--script must name a LIGGGHTS script, got %s: no such file.', ...
           script);
  end
  script = make_absolute_filename (script);
  if nargin < 2
    start = fileparts (script);
  end
  if nargin < 3
    given = struct ();
  end
  none = {cell(1, 0)};
  found = struct ('scripts', none, 'files', none, 'variables', struct (), ...
                  'missing', none, 'open', none, 'written', none, ...
                  'text', '', 'commands', scriptCommands (''), ...
                  'values', struct (), 'given', given, ...
                  'place', make_absolute_filename (start), 'stack', none);
  found = follow (found, script);
  found.files = setdiff (unique (found.files), script)(:)';
  for name = {'missing', 'open', 'written'}
    found.(name{1}) = unique (found.(name{1}))(:)';
  end
  found = rmfield (found, {'values', 'given', 'place', 'stack'});
end

% A script may be included many times, but not from within itself.
function found = follow (found, script)
  if any (strcmp (script, found.stack)) || numel (found.stack) > 20
    return
  end
  text = readText (script);
  commands = scriptCommands (text);
  if ~any (strcmp (script, found.scripts))
    found.scripts{end + 1} = script;
    found.text = [found.text, text, "\n"];
    found.commands = [found.commands, commands];
  end
  found.stack{end + 1} = script;
  for command = commands
    found = carryOut (found, command);
  end
  found.stack(end) = [];
end

function found = carryOut (found, command)
  words = command.words;
  if strcmp (words{1}, 'variable') && numel (words) > 3
    [found.values, found.variables] = ...
      scriptVariable (words, command.isSure, found.given, found.values, ...
                      found.variables);
  elseif numel (words) > 2 && all (strcmp (words(1:2), {'shell', 'cd'}))
    found.place = pathIn (found, expandWord (words{3}, found.values){1});
  end
  [isRead, isWritten] = scriptRoles (words);
  isScript = any (strcmp (words{1}, {'include', 'jump'}));
  for k = find (isRead)
    found = takeRead (found, words{k}, words{1}, isScript);
  end
  found = takeOthers (found, words(~isRead & ~isWritten));
  for k = find (isWritten)
    names = expandWord (words{k}, found.values);
    names = names(~cellfun (@(n) any (n == '$'), names));
    found.written = [found.written, ...
                     cellfun(@(n) pathIn (found, n), names, ...
                             'UniformOutput', false)];
  end
end

function path = pathIn (found, name)
  if isempty (name) || name(1) ~= '/'
    name = [found.place, '/', name];
  end
  path = plainPath (name);
end

% A file that the command must find.
function found = takeRead (found, word, command, isScript)
  for name = namesOf (found, word)
    path = pathIn (found, name{1});
    if strcmp (name{1}, 'SELF') || any (strcmp (path, found.written))
      continue
    end
    paths = {path};
    if any (path == '*')
      paths = glob (strrep (path, '[', '\['))';
    end
    paths = paths(isfile (paths));
    what = sprintf ('%s (%s in %s)', name{1}, command, ...
                    regexprep (found.stack{end}, '^.*/', ''));
    if any (name{1} == '$') && isempty (paths)
      found.open{end + 1} = what;
    elseif isempty (paths)
      found.missing{end + 1} = what;
    elseif name{1}(1) ~= '/'
      found.files = [found.files, paths];
    end
    for next = paths(1:end * isScript)
      found = follow (found, next{1});
    end
  end
end

% What a word stands for; itself where a file has just that name.
function names = namesOf (found, word)
  names = {word};
  if ~isfile (pathIn (found, word))
    names = expandWord (word, found.values);
  end
end

% Any other word, of commands that nobody has told of, may be one.
function found = takeOthers (found, words)
  isNumber = ~cellfun ('isempty', regexp (words, '^[-+.\de]+$', 'once'));
  for k = find (~isNumber)
    if numel (words{k}) > 200 || any (words{k} == "\n")
      continue
    end
    for name = expandWord (words{k}, found.values)
      if isThere (found, name{1})
        found.files{end + 1} = pathIn (found, name{1});
      end
    end
  end
end

function yes = isThere (found, name)
  yes = ~isempty (name) && name(1) ~= '/' && ...
        exist ([found.place, '/', name], 'file') == 2 && ...     % of most there is none
        ~any (strcmp (pathIn (found, name), found.written)) && ...
        ~strcmp (name, 'log.liggghts');
end

%!function put (folder, name, text)
%!  [~, ~] = mkdir (fileparts (fullfile (folder, name)));
%!  writeAtomic (fullfile (folder, name), text);
%!endfunction
%!function names = short (folder, paths)
%!  names = sort (strrep (paths, [folder, '/'], ''));
%!endfunction
%!test
%! script = tempname ();
%! writeAtomic (script, ["variable a index 2\nvariable b index 1,5\n", ...
%!                       "variable c index i\nvariable a index 4\n", ...
%!                       "variable rpm index 5 10 20\n"]);
%! found = scriptFiles (script);
%! assert (found.files, cell (1, 0));
%! assert (found.variables, struct ('a', 2));
%!error id=DEcalioc:scriptFiles:missingFile scriptFiles ('/nowhere/in.x')
%!test
%! % a script in steps; what a trial by hand has written stays where it is
%! folder = tempname ();
%! put (folder, 'in.1', "variable mu index 0.5\nrun 1\njump in.2\n");
%! put (folder, 'in.2', ...
%!      ["if \"${mu} > 9\" then \"jump in.2\" else \"jump in.3\"\n", ...
%!       "if \"${mu} > 1\" then \"print 'x' file late\"\n"]);
%! put (folder, 'in.3', ...
%!      ["read_restart settled\ndump d all custom 10 end.dump id x\n", ...
%!       "fix m all mesh/surface file box.stl type 1\n", ...
%!       "fix p all print 10 \"${mu}\" file force.txt screen no\n", ...
%!       "fix v all ave/time 1 1 10 v_mu file mean.txt\nlog own.log\n", ...
%!       "restart 100 a.rst b.rst\nwrite_restart settled\n", ...
%!       "fix f all massflow/mesh mesh m file flow.txt\n", ...
%!       "print \"${nu}\" &\n  append out\nvariable nu index 2\n", ...
%!       "write_data state\nread_data state\nprint \"RUN COMPLETE\"\n"]);
%! written = {'end.dump', 'force.txt', 'mean.txt', 'own.log', 'a.rst', 'out', ...
%!            'b.rst', 'late', 'log.liggghts', 'flow.txt', 'state'};
%! cellfun (@(name) put (folder, name, '1'), [written, {'settled', 'box.stl'}]);
%! found = scriptFiles (fullfile (folder, 'in.1'));
%! assert (short (folder, found.files), {'box.stl', 'in.2', 'in.3', 'settled'});
%! assert (found.variables, struct ('mu', 0.5, 'nu', 2));
%! assert (~isempty (strfind (found.text, 'RUN COMPLETE')));
%! assert ({found.missing, found.open}, {cell(1, 0), cell(1, 0)});
%! unlink (fullfile (folder, 'in.3'));
%! assert (scriptFiles (fullfile (folder, 'in.1')).missing, ...
%!         {'in.3 (jump in in.2)'});
%!test
%! % names by variables, beside the folder, with blanks, of a loop, of a pattern
%! folder = tempname ();
%! put (folder, 'run/in.x', ...
%!      ["variable dir string ../STL\nvariable MESH index drum.stl\n", ...
%!       "fix a all mesh/surface file ${dir}/${MESH} type 2\n", ...
%!       "fix b all mesh/surface file \"my lid.stl\" type 2\n", ...
%!       "variable n loop 2\nread_data g${n}.data\ninclude ${what}.inc\n", ...
%!       "variable MESH index never.stl\nread_restart s.*.rst\njump SELF l\n", ...
%!       "if \"1 > 2\" then \"variable w string u\" else \"variable w string v\"\n", ...
%!       "include $w.inc\nfix c all mesh/surface file /etc/hostname type 2\n", ...
%!       "shell cd deep\ninclude more.inc\nfix p all mesh/surface file no.stl\n"]);
%! names = {'STL/drum.stl', 'run/my lid.stl', 'run/g1.data', 'run/g2.data', ...
%!          'run/s.10.rst', 'run/u.inc', 'run/v.inc', 'run/deep/more.inc'};
%! cellfun (@(name) put (folder, name, '#'), names);
%! found = scriptFiles (fullfile (folder, 'run', 'in.x'));
%! assert (short (folder, found.files), sort (names));
%! assert (found.open, {'${what}.inc (include in in.x)'});
%! assert (found.missing, {'no.stl (fix in in.x)'});
%! % what -var hands over counts
%! found = scriptFiles (fullfile (folder, 'run', 'in.x'), ...
%!                      fullfile (folder, 'run'), struct ('MESH', 3));
%! assert (any (strcmp ('../STL/3 (fix in in.x)', found.missing)));

% SPDX-License-Identifier: GPL-3.0-only
