% SCRIPTFILES  The files that a LIGGGHTS script names, and its variables.
%
% CALL: [FILES, VARIABLES, TEXT] = scriptFiles (SCRIPT)
%
%   SCRIPT     path of the script (text)
%   FILES      1 x n cell of paths below its folder: every word of the script
%              that is a file there (meshes, included scripts and what those
%              name), the script itself left out
%   VARIABLES  scalar struct of numbers: what "variable NAME index VALUE"
%              declares in the script and in what it includes
%   TEXT       the script and the text files that it includes
%
% Errors: DEcalioc:scriptFiles:missingFile

function [files, variables, text] = scriptFiles (script)
  if ~isfile (script)
    error ('DEcalioc:scriptFiles:missingFile', ...
           '--script must name a LIGGGHTS script, got %s: no such file.', ...
           script);
  end
  text = checkReadText (script);
  folder = fileparts (make_absolute_filename (script));
  [~, base, ending] = fileparts (script);
  files = cell (1, 0);
  open = {[base, ending]};
  while ~isempty (open)
    part = checkReadText (fullfile (folder, open{1}));
    [found, included] = namesIn (part, folder);
    new = setdiff (found, [files, {[base, ending]}]);
    files = [files, new(:)'];
    open = [open(2:end), intersect(included, new)(:)'];
    if ~isempty (open)
      text = [text, "\n", checkReadText(fullfile (folder, open{1}))];
    end
  end
  variables = struct ();
  found = regexp (text, '^[ \t]*variable[ \t]+(\w+)[ \t]+index[ \t]+(\S+)', ...
                  'tokens', 'lineanchors');
  for k = 1:numel (found)
    value = str2double (found{k}{2});
    if isfinite (value) && ~isfield (variables, found{k}{1})
      variables.(found{k}{1}) = value;
    end
  end
end

% Only names below the folder: what lies elsewhere stays where it is.
function [names, included] = namesIn (text, folder)
  text = regexprep (text, '#[^\n]*', '');
  words = unique (strsplit (strtrim (text)));
  isBelow = cellfun (@(w) ~isempty (w) && w(1) ~= '/' && ...
                     isempty (strfind (w, '..')), words);
  names = words(isBelow);
  names = names(cellfun (@(w) isfile (fullfile (folder, w)), names));
  included = regexp (text, '^[ \t]*include[ \t]+(\S+)', 'tokens', ...
                     'lineanchors');
  included = cellfun (@(t) t{1}, included, 'UniformOutput', false);
end

%!test
%! folder = tempname ();
%! mkdir (fullfile (folder, 'meshes'));
%! put = @(name, text) writeAtomic (fullfile (folder, name), text);
%! put ('in.mine', ["variable mu index 0.3 0.4 # first counts\n", ...
%!                  "variable name index abc\ninclude more.inc\n", ...
%!                  "# not.this\nfix a all mesh/surface file meshes/a.stl\n"]);
%! put ('more.inc', "variable r index 1e-3\nread_data grains.data\n");
%! put ('meshes/a.stl', 'solid');
%! put ('grains.data', 'x');
%! put ('not.this', 'x');
%! [files, variables, text] = scriptFiles (fullfile (folder, 'in.mine'));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
%! assert (sort (files), {'grains.data', 'meshes/a.stl', 'more.inc'});
%! assert (variables, struct ('mu', 0.3, 'r', 1e-3));
%! assert (~isempty (strfind (text, 'read_data')));
%!error id=DEcalioc:scriptFiles:missingFile scriptFiles ('/nowhere/in.x')
