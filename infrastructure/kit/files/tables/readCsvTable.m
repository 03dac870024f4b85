% READCSVTABLE  Reads a CSV file with a header line into a cell of texts.
%
% CALL: [HEADER, CELLS, LINES] = readCsvTable (FILE)
%       [HEADER, CELLS, LINES] = readCsvTable (FILE, NAMES)
%
%   FILE    path of the file, text as readText takes it; fields separated by
%           comma, or by semicolon, tab or bar, or as a first line sep=; says, or
%           by blanks alone, where all rows have as many words; quoted fields
%           with doubled quotes inside; numbers as clearNumbers takes them;
%           remarks and titles as in plainTable; a header that stands again below
%           is left out, and so are the quoted names of rows that R writes
%   NAMES   1 x m cell: what the first columns are called in a table that begins
%           with a row of numbers
%   HEADER  1 x c cellstr, column names without outer blanks; columns without
%           name and content are left out
%   CELLS   n x c cellstr, fields without outer blanks; empty rows are left out
%   LINES   n x 1, line number of each row in the file
%
% Errors: DEcalioc:readCsvTable:missingFile, DEcalioc:readCsvTable:badShape,
% DEcalioc:readCsvTable:unclearPoint (1.002 beside decimal commas)

function [header, cells, lines] = readCsvTable (file, names)
  [id, message] = fopen (file, 'r');
  if id < 0
    error ('DEcalioc:readCsvTable:missingFile', ...
           'readCsvTable: FILE must be readable, got %s: %s.', file, message);
  end
  fclose (id);
  text = readText (file);
  if any (text == 0)
    error ('DEcalioc:readCsvTable:badShape', ...
           ['readCsvTable: %s must be text in UTF-8, got NUL bytes (UTF-16 ' ...
            'without its mark, or no text). Save it as CSV UTF-8.'], file);
  end
  added = false;
  if nargin > 1
    [text, added] = withHeader (text, names);
  end
  [fields, row, lines, delimiter, isNamed] = splitFields (plainTable (text));
  lines = lines - added;
  if isempty (fields)
    error ('DEcalioc:readCsvTable:badShape', ...
           'readCsvTable: %s must have a header line, got an empty file.', ...
           file);
  end
  fields = clearNumbers (fields, ...
                         @(k) sprintf ('line %d of %s', lines(row(k)), file), ...
                         delimiter == ',');
  [fields, row] = withRowNames (fields, row, isNamed);
  header = fields(row == 1)';
  % Excel ends rows with separators of columns that are empty
  before = [0; cumsum(accumarray (row, 1))];
  column = (1:numel (row))' - before(row);
  spare = column > numel (header);
  count = accumarray (row(~spare), 1);
  bad = find (count ~= numel (header), 1);
  filled = row(spare & ~cellfun ('isempty', fields));
  if ~isempty (filled)
    bad = min ([bad; filled]);
  end
  if ~isempty (bad)
    refuseRow (file, lines(bad), numel (header), sum (row == bad), delimiter);
  end
  cells = reshape (fields(~spare), numel (header), [])';
  isHeader = all (strcmp (cells, repmat (cells(1, :), rows (cells), 1)), 2);
  [cells, lines] = deal (cells(~isHeader, :), lines(~isHeader));
  isBlank = strcmp (header, '') & all (cellfun ('isempty', cells), 1);
  [header, cells] = deal (header(~isBlank), cells(:, ~isBlank));
end

% A first line of numbers gets the NAMES above it, parted as they are: a comma is
% a decimal one where something else parts them.
function [text, isAdded] = withHeader (text, names)
  lead = regexp (text, '^([ \t]*((#|%|//)[^\n]*)?\n)*', 'match', 'once');
  first = regexp (text(numel (lead) + 1:end), '^[^\n]*', 'match', 'once');
  words = strtrim (strsplit (strtrim (first), {';', "\t", '|'}));
  mark = regexp (first, '[;\t|]', 'match', 'once');
  if isempty (mark)
    words = regexp (strtrim (first), ' +', 'split');
    mark = ' ';
    if isscalar (words) || any (cellfun (@(w) w(end) == ',', words))
      words = strtrim (regexp (strtrim (first), '("[^"]*"|[^",])+', 'match'));
      mark = ',';
    end
  end
  isNumber = ~cellfun (@isempty, regexp (words, '^"?[-+]?[\d.,]*\d([dDeE][-+]?\d+)?"?$', 'once'));
  isAdded = all (isNumber | cellfun (@isempty, words)) && any (isNumber);
  if isAdded
    names = [names, arrayfun(@(k) sprintf ('column %d', k), ...
                             numel (names) + 1:numel (words), ...
                             'UniformOutput', false)];
    if mark == ' '
      names = strrep (names, ' ', '_');
    end
    header = strjoin (names(1:numel (words)), mark);
    text = [lead, header, "\n", text(numel (lead) + 1:end)];
  end
end

% R writes no name above the names of its rows, which are quoted.
function [fields, row] = withRowNames (fields, row, isNamed)
  count = accumarray (row, 1);
  if all (isNamed) && numel (count) > 1 && all (count(2:end) == count(1) + 1)
    fields = [{''}; fields];
    row = [1; row];
  end
end

function refuseRow (file, line, wanted, got, delimiter)
  cure = '';
  if delimiter == ',' && got > wanted
    cure = [' Decimal commas between commas cannot be told apart: save it ' ...
            'with semicolons, or with decimal points.'];
  end
  error ('DEcalioc:readCsvTable:badShape', ...
         ['readCsvTable: line %d of %s must have %d fields as the header, ' ...
          'got %d.%s'], line, file, wanted, got, cure);
end

% All fields (cell, n x 1), the number of the row that each belongs to, the line
% of each row, whether it begins with a quote. Rows without any text are left out.
function [fields, row, lines, delimiter, isNamed] = splitFields (text)
  skipped = numel (regexp (text, '^([ \t]*\n)*', 'match', 'once'));
  text = [text(skipped + 1:end), "\n"];
  quoted = mod (cumsum (text == '"'), 2) == 1;
  first = text(1:find ([text == "\n" & ~quoted, true], 1) - 1);
  given = regexp (first, '^"?sep=(.)"?;*,*\s*$', 'tokens', 'once');
  if ~isempty (given)
    delimiter = given{1};
    text = text(numel (first) + 2:end);
    quoted = quoted(numel (first) + 2:end);
    skipped = skipped + 1;
  else
    plain = first(~quoted(1:numel (first)));
    % a place: p@0,5; types: friction(1,2)
    plain = regexprep (plain, {'(@\s*[-+]?\d*),(?=\d)', '\(\d+,\s*\d+\)'}, {'$1.', ''});
    kinds = ",\t;|,";
    delimiter = kinds(find ([ismember(kinds(1:4), plain), true], 1));
  end
  isEnd = text == "\n" & ~quoted;
  if isempty (text) || ~isEnd(end)
    isEnd(end + 1) = true;                    % quotes left open
  end
  isCut = isEnd;
  isCut(1:numel (text)) = isEnd(1:numel (text)) | text == delimiter & ~quoted;
  cuts = find (isCut);
  fields = cellslices (text, [1, cuts(1:end - 1) + 1], cuts - 1)';
  isNamed = strncmp (fields, '"', 1);
  fields = clean (fields, text);
  row = cumsum ([1; isEnd(cuts(1:end - 1))']);
  number = cumsum ([1, text == "\n"]) + skipped;
  starts = [1, find(isEnd) + 1];
  lines = number(starts(1:end - 1))';
  full = accumarray (row, ~cellfun ('isempty', fields)) > 0;
  fields = fields(full(row));
  order = cumsum (full);
  isNamed = isNamed(full(row));
  row = order(row(full(row)));
  isNamed = isNamed(diff ([0; row]) > 0);
  lines = lines(full);
end

function fields = clean (fields, text)
  % each of these takes a second for 100,000 rows
  if any (isspace (text) & text ~= "\n")
    fields = strtrim (fields);
  end
  if any (text == '"')
    isQuoted = ~cellfun ('isempty', regexp (fields, '^".*"$', 'once'));
    fields(isQuoted) = cellfun (@(f) strtrim (strrep (f(2:end - 1), '""', ...
                                                      '"')), ...
                                fields(isQuoted), 'UniformOutput', false);
  end
  fields(cellfun ('isempty', fields)) = {''};
end

%!function [header, cells, lines] = read (text)
%!  file = tempname ();
%!  writeAtomic (file, text);
%!  [header, cells, lines] = readCsvTable (file);
%!endfunction
%!assert (read ("a;p@0,002\n1;2,5\n"), {'a', 'p@0,002'})
%!test
%! bom = char ([239, 187, 191]);
%! [header, cells, lines] = read ([bom, 'a,"b, c"', "\r\n", ...
%!                                 ' 1 ,"x ""y"""', "\r\n\r\n", '2,']);
%! assert (header, {'a', 'b, c'});
%! assert (cells, {'1', 'x "y"'; '2', ''});
%! assert (lines, [2; 4]);
%! [~, cells] = read ("a;b\n1,5;2\n");
%! assert (cells, {'1.5', '2'});
%! [header, cells] = read ("\"a\";\"b, c\"\n\"-1,5e-3\";\"x, y\"\n");
%! assert ({header, cells}, {{'a', 'b, c'}, {'-1.5e-3', 'x, y'}});
%! % remarks before the header
%! [header, cells, lines] = read ("# of: sand\r\n# by: me\na,b\n1,2\n");
%! assert ({header, cells, lines}, {{'a', 'b'}, {'1', '2'}, 4});
%!test
%! % what Excel makes: its line sep=, rows of separators alone, UTF-16, tabs
%! plain = "a;b\r\n1,5;2\r\n;;;\r\n3;\r\n;\r\n";
%! pairs = [double(plain); zeros(1, numel (plain))];
%! wide = [char([255, 254]), char(reshape (pairs, 1, []))];
%! big = [char([254, 255]), char(reshape (flipud (pairs), 1, []))];
%! forms = {plain, ["sep=;\r\n", plain], wide, big, strrep(plain, ';', "\t")};
%! for k = 1:numel (forms)
%!   [header, cells, lines] = read (forms{k});
%!   assert ({header, cells}, {{'a', 'b'}, {'1.5', '2'; '3', ''}});
%!   assert (lines, [2; 4] + (k == 2));
%! end
%!test
%! % Excel's plain CSV is Windows-1252
%! [header, cells] = read (["a;H", char(246), "he\n30 ", char(176), ";1,5\n"]);
%! assert (header{2}, ['H', char([195, 182]), 'he']);
%! assert (cells, {['30 ', char([194, 176])], '1.5'});
%!test
%! % a thousand dot; columns without name and content
%! [header, cells] = read ("a;;b;;\n26,5;;1.002,25;;\n,5;;0.75;;\n");
%! assert (header, {'a', 'b'});
%! assert (cells, {'26.5', '1002.25'; '.5', '0.75'});
%! [~, cells] = read ("a;b\n3;1.002\n");
%! assert (cells, {'3', '1.002'});
%! [~, cells] = read ("a;tol\n1,500;2,5 %\n1;0,5 abs\n");
%! assert (cells, {'1.500', '2.5 %'; '1', '0.5 abs'});
%!test
%! % numpy's header, blanks between columns, units behind a blank
%! for text = {"# by me\n# a b c\n1 2 3\n4 5 6\n", "# a,b,c\n1,2,3\n4,5,6\n", ...
%!             "a  b c\n 1 2   3\n4 5 6\n\n"}
%!   [header, cells] = read (text{1});
%!   assert ({header, cells}, {{'a', 'b', 'c'}, {'1', '2', '3'; '4', '5', '6'}});
%! end
%! [header, cells] = read ("a [deg] b (m/s)\n0,5 2\n");
%! assert ({header, cells}, {{'a [deg]', 'b (m/s)'}, {'0.5', '2'}});
%! [header, cells] = read ("run out\n1\n2\n");
%! assert ({header, cells}, {{'run out'}, {'1'; '2'}});
%! % a remark of other words stays one
%! [header, cells] = read ("# my heap of 2026\na,b\n1,2\n");
%! assert (header, {'a', 'b'});
%!test
%! % a table without a header, by whatever its columns are parted
%! for text = {"0,5;52\n0,6;4,5\n", "0,5\t52\n0,6\t4,5\n", "0,5 52\n0,6 4,5\n", ...
%!             "0.5,52\n0.6,4.5\n", "# mine\n0.5 52\n0.6 4.5\n", "0.5, 52\n0.6, 4.5\n"}
%!   file = tempname ();
%!   writeAtomic (file, text{1});
%!   [header, cells, lines] = readCsvTable (file, {'t', 'f', 'sd'});
%!   assert ({header, cells}, {{'t', 'f'}, {'0.5', '52'; '0.6', '4.5'}});
%!   assert (lines, [1; 2] + (text{1}(1) == '#'));
%! end
%! writeAtomic (file, "a;b\n1;2\n");
%! assert (readCsvTable (file, {'t', 'f'}), {'a', 'b'});
%!error id=DEcalioc:readCsvTable:unclearPoint read ("a;b\n26,5;\n;1.002\n")
%!error <Write 1002 or 1,002> read ("a\tb\n26,5\t\n\t1.002\n")
%!error <save it with semicolons> read ("a,b\n0,5,2\n")
%!error <UTF-16> read (["a", 0, ";", 0, "b", 0])
%!error id=DEcalioc:readCsvTable:missingFile readCsvTable ('/no/such/file')
%!error id=DEcalioc:readCsvTable:badShape read ("a,b\n1\n")
%!error id=DEcalioc:readCsvTable:badShape read ('')

% SPDX-License-Identifier: GPL-3.0-only
