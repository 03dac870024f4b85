% READVTK  Columns of the particles of a vtk file, by their names.
%
% CALL: TABLE = readVtk (TEXT, NAMES, FILE)
%
%   TEXT   of a legacy vtk file as text
%   NAMES  1 x c cell: x, y, z (POINTS), fields of POINT_DATA with one number,
%          or NAMEx, NAMEy, NAMEz of those with three
%   FILE   its path, for errors
%   TABLE  n x c numbers
%
% Throws DEcalioc:readVtk:badShape (binary, no points, one that breaks off),
% DEcalioc:readVtk:unknownName.
%
% See also: readDump

function table = readVtk (text, names, file)
  [count, last] = regexp (text, '^POINTS\s+(\d+)\s+\w+', 'tokens', 'end', ...
                          'once', 'lineanchors');
  isText = ~isempty (regexp (text(1:min (end, 400)), '^ASCII\s*$', 'once', ...
                             'lineanchors'));
  if ~isText || isempty (count)
    error ('DEcalioc:readVtk:badShape', ...
           ['readVtk: %s must be a legacy vtk file of points as text, got ' ...
            'another one. Write it as text (dump_modify ID binary no).'], file);
  end
  n = str2double (count{1});
  columns = struct ();
  columns = withColumns (columns, '', text(last + 1:end), 3, n);
  form = ['^(?:SCALARS\s+(\S+)\s+\w+(?:[ \t]+(\d+))?\s+LOOKUP_TABLE\s+\w+|', ...
          'VECTORS\s+(\S+)\s+\w+|(\w+)\s+(\d+)\s+', count{1}, '\s+\w+)[ \t]*$'];
  [words, ends] = regexp (text, form, 'match', 'end', 'lineanchors');
  for k = 1:numel (ends)
    [name, width] = fieldOf (words{k});
    columns = withColumns (columns, name, text(ends(k) + 1:end), width, n);
  end
  isThere = isfield (columns, names);
  if ~all (isThere)
    error ('DEcalioc:readVtk:unknownName', ...
           ['readVtk: NAMES must be fields of %s, got %s. It has: %s. Add ' ...
            'the name to the dump command.'], file, ...
           names{find(~isThere, 1)}, strjoin (fieldnames (columns)', ' '));
  end
  table = cell2mat (cellfun (@(name) columns.(name), names(:)', ...
                             'UniformOutput', false));
end

function [name, width] = fieldOf (line)
  words = strsplit (strtrim (line));
  name = words{1};
  width = str2double (words{2});
  if strcmp (name, 'VECTORS')
    [name, width] = deal (words{2}, 3);
  elseif strcmp (name, 'SCALARS')
    name = words{2};
    width = max ([1, str2double(words{4}(isdigit (words{4})))]);
  end
end

% What breaks off or has other than 1 or 3 numbers a point is left out.
function columns = withColumns (columns, name, text, width, n)
  values = sscanf (text, '%f', width * n);
  if numel (values) == width * n && width == 1
    columns.(name) = values;
  elseif numel (values) == width * n && width == 3
    table = reshape (values, 3, n).';
    for k = 1:3
      columns.([name, 'xyz'(k)]) = table(:, k);
    end
  end
end

%!shared text
%! text = "# vtk DataFile Version 2.0\nx\nASCII\nPOINTS 1 float\n1 2 3\n";
%!assert (readVtk (text, {'z', 'x'}, 'f'), [3, 1])
%!error id=DEcalioc:readVtk:unknownName readVtk (text, {'radius'}, 'f')
%!error id=DEcalioc:readVtk:badShape
%! readVtk (strrep (text, 'ASCII', 'BINARY'), {'x'}, 'f');

% SPDX-License-Identifier: GPL-3.0-only
