% FIGURETABLES  All tables of the manual: a handle each.
%
% CALL: TABLES = figureTables ()
%
%   TABLES  struct of handles, see calibrationTables: those of all functions
%           *Tables.m beside this one
%
% See also: writeFigures

function tables = figureTables ()
  tables = struct ();
  for file = sort (readdir (fileparts (mfilename ('fullpath'))))'
    if regexp (file{1}, '[a-z]Tables\.m$') && ~strcmp (file{1}, 'figureTables.m')
      part = feval (file{1}(1:end - 2));
      for name = fieldnames (part)'
        tables.(name{1}) = part.(name{1});
      end
    end
  end
end

%!assert (isa (figureTables ().bends, 'function_handle'))

% SPDX-License-Identifier: GPL-3.0-only
