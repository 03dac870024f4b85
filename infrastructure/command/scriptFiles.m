% SCRIPTFILES  What a LIGGGHTS script names: files below it, and variables.
%
% CALL: [FILES, VARIABLES, TEXT] = scriptFiles (SCRIPT)
%
%   SCRIPT     path of the script (text)
%   FILES      1 x n cell of words of the script, and of the scripts it includes
%              or jumps to, that are files below its folder, without those that
%              they write (and do not read)
%   VARIABLES  scalar struct: the numbers that "variable NAME index VALUE"
%              declares; the first one of a name counts
%   TEXT       the script and those it includes or jumps to (text)
%
% Errors: DEcalioc:scriptFiles:missingFile

function [files, variables, text] = scriptFiles (script)
  if ~isfile (script)
    error ('DEcalioc:scriptFiles:missingFile', ...
           '--script must name a LIGGGHTS script, got %s: no such file.', ...
           script);
  end
  folder = fileparts (make_absolute_filename (script));
  [~, base, ending] = fileparts (script);
  % what lies elsewhere stays where it is
  isBelow = @(w) w(1) ~= '/' && isempty (strfind (w, '..')) && ...
                 isfile (fullfile (folder, w));
  files = cell (1, 0);
  base = [base, ending];
  open = {base};
  text = '';
  while ~isempty (open)
    part = checkReadText (fullfile (folder, open{1}));
    text = [text, part, "\n"];
    lines = commandsIn (part);
    next = regexp (lines, '^(?:include|jump)\s+(\S+)', 'tokens', 'once');
    next = [next{:}, cell(1, 0)];
    words = regexprep (strsplit (strjoin (lines, ' ')), '^["'']+|["'']+$', '');
    new = setdiff (words, [files, writtenBy(lines), {'', base}])(:)';
    new = new(cellfun (isBelow, new));
    files = [files, new];
    open = [open(2:end), intersect(next, new)(:)'];
  end
  variables = numbersIn (text);
end

% Commands without comments; those in the quotes of an if stand behind it.
function lines = commandsIn (text)
  text = regexprep (text, '&[ \t]*\n', ' ');
  lines = strtrim (strsplit (regexprep (text, '#[^\n]*', ''), "\n"));
  conditions = strjoin (lines(strncmp (lines, 'if ', 3)), "\n");
  inside = regexp (conditions, '"([^"\n]*)"', 'tokens');
  lines = [lines, strtrim([cell(1, 0), inside{:}])];
end

% What a run makes, and what a trial by hand has left therefore.
function names = writtenBy (lines)
  forms = {'^(?:write_restart|write_data|log)\s+(\S+)', ...
           '^dump(?:\s+\S+){4}\s+(\S+)', ...
           '^write_dump(?:\s+\S+){2}\s+(\S+)', ...
           '^restart\s+\S+\s+(\S+)', '^restart\s+\S+\s+\S+\s+(\S+)', ...
           ['^(?:print|fix\s+\S+\s+\S+\s+(?:print|ave/)).*\s', ...
            '(?:file|append)\s+(\S+)']};
  names = {'log.liggghts'};
  for form = forms
    found = regexp (lines, form{1}, 'tokens', 'once');
    names = [names, found{:}];
  end
  read = regexp (lines, '^(?:read_\w+|include|jump)\s+(\S+)', 'tokens', ...
                 'once');
  names = setdiff (names, [{''}, read{:}]);
end

function variables = numbersIn (text)
  variables = struct ();
  found = regexp (text, '^[ \t]*variable[ \t]+(\w+)[ \t]+index[ \t]+(\S+)', ...
                  'tokens', 'lineanchors');
  for k = 1:numel (found)
    [name, word] = found{k}{:};
    value = str2double (word);
    % to str2double 1,5 is 15, and the word i a complex number
    isNumber = isfinite (value) && isreal (value) && ~any (word == ',');
    if isNumber && ~isfield (variables, name)
      variables.(name) = value;
    end
  end
end

%!test
%! script = tempname ();
%! writeAtomic (script, ["variable a index 2 3\nvariable b index 1,5\n", ...
%!                       "variable c index i\nvariable a index 4\n"]);
%! [files, variables] = scriptFiles (script);
%! assert (files, cell (1, 0));
%! assert (variables, struct ('a', 2));
%!error id=DEcalioc:scriptFiles:missingFile scriptFiles ('/nowhere/in.x')
%!test
%! % a script in steps; what a trial by hand has written stays where it is
%! folder = tempname ();
%! mkdir (folder);
%! put = @(name, text) writeAtomic (fullfile (folder, name), text);
%! put ('in.1', "variable mu index 0.5\nrun 1\njump in.2\n");
%! put ('in.2', ["if \"${mu} > 9\" then \"jump in.2\" else \"jump in.3\"\n", ...
%!               "if \"${mu} > 1\" then \"print 'x' file late\"\n"]);
%! put ('in.3', ["read_restart settled\ndump d all custom 10 end.dump id x\n", ...
%!               "fix m all mesh/surface file box.stl type 1\n", ...
%!               "fix p all print 10 \"${mu}\" file force.txt screen no\n", ...
%!               "fix v all ave/time 1 1 10 v_mu file mean.txt\nlog own.log\n", ...
%!               "restart 100 a.rst b.rst\nwrite_restart settled\n", ...
%!               "print \"${nu}\" &\n  append out\nvariable nu index 2\n", ...
%!               "print \"RUN COMPLETE\"\n"]);
%! written = {'end.dump', 'force.txt', 'mean.txt', 'own.log', 'a.rst', ...
%!            'b.rst', 'out', 'late', 'log.liggghts'};
%! cellfun (@(name) put (name, '1'), [written, {'settled', 'box.stl'}]);
%! [files, variables, text] = scriptFiles (fullfile (folder, 'in.1'));
%! assert (sort (files), {'box.stl', 'in.2', 'in.3', 'settled'});
%! assert (variables, struct ('mu', 0.5, 'nu', 2));
%! assert (~isempty (strfind (text, 'RUN COMPLETE')));
