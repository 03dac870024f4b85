% READSERIES  Columns of a series that a run has written, by their names.
%
% CALL: TABLE = readSeries (TEXT, NAMES)
%
%   TEXT   of the file: rows of numbers with blanks, commas, semicolons or tabs
%          between. A line before them, with or without #, names the columns (of
%          several the last one that does): a csv, fix ave/time, fix print with
%          a title, the thermo output of LIGGGHTS in a log, of which the last
%          block counts
%   NAMES  1 x m cell of names of columns; v_NAME, f_NAME, c_NAME and a unit
%          behind it in brackets are the same
%   TABLE  n x m numbers, [] where a name has no column. Where no line names
%          columns, those of NAMES are all that there are, perhaps behind one
%          for the step, in two rows at least
%
% See also: readResults, readDump

function table = readSeries (text, names)
  table = [];
  lines = strtrim (strsplit (strrep (text, "\r", ''), "\n"));
  isRow = ~cellfun (@isempty, regexp (lines, '^[-+.\d][-+.\deE\s,;]*$', 'once'));
  % the last block of rows of one width, and the line above it
  last = find (isRow, 1, 'last');
  if isempty (last)
    return
  end
  first = max ([0, find(~isRow(1:last), 1, 'last')]) + 1;
  fields = cellfun (@fieldsOf, lines(first:last), 'UniformOutput', false);
  width = numel (fields{end});
  fields = fields(cellfun (@numel, fields) == width);
  values = reshape (str2double ([fields{:}]), width, []).';
  column = headerOf (lines(1:first - 1), names, width);
  isBare = isempty (column) && rows (values) > 1 && ...
           any (width - numel (names) == [0, 1]);
  if isBare && ~isNamed (lines(1:first - 1), width)
    column = width - numel (names) + 1:width;
  end
  if ~isempty (column)
    table = values(:, column);
  end
end

function words = fieldsOf (line)
  words = regexp (line, '[^\s,;]+', 'match');
end

% Columns of NAMES, by the last line of that many words that has them all.
function column = headerOf (lines, names, width)
  column = [];
  for line = fliplr (lines(max (1, end - 5):end))
    words = wordsOf (line{1});
    [isThere, at] = ismember (bare (names), bare (words));
    if numel (words) == width && all (isThere)
      column = at;
      return
    end
  end
end

% A line of words for other columns than those that are looked for.
function yes = isNamed (lines, width)
  yes = ~isempty (lines) && numel (wordsOf (lines{end})) == width && ...
        isempty (regexp (lines{end}, '^# (Fix print|Time-aver)', 'once'));
end

function words = wordsOf (line)
  line = regexprep (line, {'^#\s*', '\s*[[(][^])]*[])]'}, '');
  words = strtrim (regexp (line, '[^,;\t]+', 'match'));
  if isscalar (words)
    words = regexp (line, '\S+', 'match');
  end
  words = regexprep (words, '^"(.*)"$', '$1');
end

function names = bare (names)
  names = regexprep (strtrim (names), {'^[vfc]_', '\s*[[(][^])]*[])]$'}, '');
end

%!assert (readSeries ("t;\"force [N]\";m\n0;1;2\n1;3;4\n", {'m', 'force'}), ...
%!        [2, 1; 4, 3])
%!assert (readSeries (["# Time-averaged data for fix v\n# TimeStep v_mu c_1\n", ...
%!                     "10 0.5 3\n20 0.6 4\n"], {'mu'}), [0.5; 0.6])
%!assert (readSeries ("# Fix print output for fix p\n0 1\n1 3\n", {'force'}), ...
%!        [1; 3])
%!assert (readSeries (["Step Atoms KinEng\n 0 5 1.5\nLoop time\n", ...
%!                     "Step Atoms KinEng\n 0 5 2.5\n 10 5 2.0\nLoop time of\n"], ...
%!                    {'KinEng'}), [2.5; 2])
%!assert (isempty (readSeries ("t,x,y\n0,1,2\n1,3,4\n", {'force'})))
%!assert (isempty (readSeries ("t,x\n0,1\n1,3\n", {'force'})))
%!assert (isempty (readSeries ("1 2 3\n", {'a', 'b'})))
%!assert (isempty (readSeries ('', {'a'})))
%!assert (readSeries ("1 2\n3 4\n", {'a', 'b'}), [1, 2; 3, 4])

% SPDX-License-Identifier: GPL-3.0-only
