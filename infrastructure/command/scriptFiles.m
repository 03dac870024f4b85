% SCRIPTFILES  What a LIGGGHTS script names: files below it, and variables.
%
% CALL: [FILES, VARIABLES, TEXT] = scriptFiles (SCRIPT)
%
%   SCRIPT     path of the script (text)
%   FILES      1 x n cell of words of the script, and of what it includes, that
%              are files below its folder
%   VARIABLES  scalar struct: the numbers that "variable NAME index VALUE"
%              declares; the first one of a name counts
%   TEXT       the script and what it includes (text)
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
  open = {[base, ending]};
  text = '';
  while ~isempty (open)
    part = checkReadText (fullfile (folder, open{1}));
    text = [text, part, "\n"];
    part = regexprep (part, '#[^\n]*', '');
    included = regexp (part, '^[ \t]*include[ \t]+(\S+)', 'tokens', ...
                       'lineanchors');
    new = setdiff (unique (strsplit (strtrim (part))), ...
                   [files, {'', [base, ending]}])(:)';
    new = new(cellfun (isBelow, new));
    files = [files, new];
    open = [open(2:end), intersect([cell(1, 0), included{:}], new)(:)'];
  end
  variables = numbersIn (text);
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
