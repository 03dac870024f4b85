% HEADDEFAULTS  Values that a data.head declares.
%
% CALL: DEFAULTS = headDefaults (FILE)
%
%   FILE      path of a data.head (text)
%   DEFAULTS  scalar struct, one field a declared variable: its number, or NaN
%             where it is a formula or a text
%
% Read are lines of the form: variable NAME equal|string VALUE  # comment
%
% Errors: DEcalioc:headDefaults:missingFile
%
% See also: writeHead, hashModels

function defaults = headDefaults (file)
  if ~ isfile (file)
    error ('DEcalioc:headDefaults:missingFile', ...
           'headDefaults: %s must exist; it declares the variables.', file);
  end
  found = regexp (fileread (file), ...
                  '^\s*variable\s+(\w+)\s+\w+\s+([^#\n]*)', ...
                  'tokens', 'lineanchors');
  defaults = struct ();
  for k = 1:numel (found)
    name = found{k}{1};
    if isvarname (name)
      defaults.(name) = str2double (strtrim (found{k}{2}));
    end
  end
end

%!test
%! file = tempname ();
%! writeAtomic (file, ["variable a equal 5e6 # Pa\n# variable no equal 1\n", ...
%!                     "variable b equal 2*${a}\n  variable a equal 7\n"]);
%! d = headDefaults (file);
%! assert (d.a, 7);
%! assert (isnan (d.b));
%! assert (sort (fieldnames (d)), {'a'; 'b'});
%! unlink (file);
%!error id=DEcalioc:headDefaults:missingFile headDefaults ('/nowhere')
