% HASHFOLDER  Hash of the files of a folder, names and contents.
%
% CALL: KEY = hashFolder (FOLDER, WITHOUT)
%
%   FOLDER   path (text); links are followed
%   WITHOUT  cell of names below FOLDER that do not count
%   KEY      64 hexadecimal digits
%
% Errors: DEcalioc:hashFolder:missingFile

function key = hashFolder (folder, without)
  skip = cellfun (@(n) [' ! -path ', shellQuote(['./', n]), ...
                        ' ! -path ', shellQuote(['./', n, '/*'])], ...
                  without, 'UniformOutput', false);
  command = ['cd ', shellQuote(folder), ' && find -L . -type f', skip{:}, ...
             ' -print0 | LC_ALL=C sort -z | xargs -0 -r sha256sum'];
  [status, text] = system (command);
  if status ~= 0
    error ('DEcalioc:hashFolder:missingFile', ...
           'hashFolder: the files of %s must be readable, got: %s', ...
           folder, strtrim (text));
  end
  key = hash ('sha256', text);
end

%!test
%! d = tempname ();
%! mkdir (d);
%! mkdir (fullfile (d, 'sub'));
%! writeAtomic (fullfile (d, 'sub', 'b'), 'x');
%! writeAtomic (fullfile (d, 'a'), 'x');
%! all1 = hashFolder (d, {});
%! part1 = hashFolder (d, {'sub'});
%! writeAtomic (fullfile (d, 'sub', 'b'), 'y');
%! assert (isequal (hashFolder (d, {'sub'}), part1));
%! assert (! isequal (hashFolder (d, {}), all1));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (d, 's');
%!error id=DEcalioc:hashFolder:missingFile hashFolder ('/nowhere/at/all', {})
