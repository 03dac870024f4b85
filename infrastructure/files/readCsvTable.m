% READCSVTABLE  Reads a CSV file with a header line into a cell of texts.
%
% CALL: [HEADER, CELLS, LINES] = readCsvTable (FILE)
%
%   FILE    path of the file: UTF-8 with or without BOM, lines ended by LF,
%           CR LF or CR, fields separated by comma (or by semicolon, with
%           decimal commas then), quoted fields with doubled quotes inside
%   HEADER  1 x c cellstr, column names without outer blanks
%   CELLS   n x c cellstr, fields without outer blanks; empty lines are left out
%   LINES   n x 1, line number of each row in the file
%
% Errors: DEcalioc:readCsvTable:missingFile, DEcalioc:readCsvTable:badShape
%
% See also: importRuns

function [header, cells, lines] = readCsvTable (file)
  [id, message] = fopen (file, 'r');
  if id < 0
    error ('DEcalioc:readCsvTable:missingFile', ...
           'readCsvTable: FILE must be readable, got %s: %s.', file, message);
  end
  text = fread (id, [1, Inf], '*char');
  fclose (id);
  if numel (text) >= 3 && isequal (double (text(1:3)), [239, 187, 191])
    text = text(4:end);
  end
  [rows_, lines] = splitFields (text);
  if isempty (rows_)
    error ('DEcalioc:readCsvTable:badShape', ...
           'readCsvTable: %s must have a header line, got an empty file.', ...
           file);
  end
  header = rows_{1};
  lines = lines(2:end);
  cells = cell (numel (rows_) - 1, numel (header));
  for i = 2:numel (rows_)
    fields = rows_{i};
    if numel (fields) > numel (header) && ...
       all (cellfun (@isempty, fields(numel (header) + 1:end)))
      fields = fields(1:numel (header));
    end
    if numel (fields) ~= numel (header)
      error ('DEcalioc:readCsvTable:badShape', ...
             ['readCsvTable: line %d of %s must have %d fields as the ' ...
              'header, got %d.'], lines(i - 1), file, numel (header), ...
             numel (fields));
    end
    cells(i - 1, :) = fields;
  end
end

function [table, lines] = splitFields (text)
  text = strrep (strrep (text, "\r\n", "\n"), "\r", "\n");
  quoted = mod (cumsum (text == '"'), 2) == 1;
  first = 1:find ([text == "\n" & ~quoted, true], 1) - 1;
  first = text(first(~quoted(first)));
  delimiter = ',';
  if any (first == ';') && ~any (first == ',')
    delimiter = ';';
  end
  ends = [find(text == "\n" & ~quoted), numel(text) + 1];
  table = {};
  lines = zeros (0, 1);
  start = 1;
  number = 1;
  for stop = ends
    at = start:stop - 1;
    if any (~isspace (text(at)))
      table{end + 1} = fieldsOf (text(at), quoted(at), delimiter);
      lines(end + 1, 1) = number;
    end
    number = number + 1 + sum (text(at) == "\n");
    start = stop + 1;
  end
end

function fields = fieldsOf (line, quoted, delimiter)
  cuts = [0, find(line == delimiter & ~quoted), numel(line) + 1];
  fields = cell (1, numel (cuts) - 1);
  for k = 1:numel (fields)
    field = strtrim (line(cuts(k) + 1:cuts(k + 1) - 1));
    if numel (field) >= 2 && field(1) == '"' && field(end) == '"'
      field = strtrim (strrep (field(2:end - 1), '""', '"'));
    end
    if delimiter == ';' && isNumber (field)
      field = strrep (field, ',', '.');
    end
    fields{k} = field;
  end
end

function yes = isNumber (field)
  yes = ~isempty (regexp (field, '^[-+]?\d*,\d*([eE][-+]?\d+)?$', 'once'));
end

%!function file = written (text)
%!  file = tempname ();
%!  id = fopen (file, 'w');
%!  fwrite (id, text);
%!  fclose (id);
%!endfunction
%!test
%! bom = char ([239, 187, 191]);
%! file = written ([bom, 'a,"b, c"', "\r\n", ' 1 ,"x ""y"""', ...
%!                  "\r\n\r\n", '2,']);
%! [header, cells, lines] = readCsvTable (file);
%! delete (file);
%! assert (header, {'a', 'b, c'});
%! assert (cells, {'1', 'x "y"'; '2', ''});
%! assert (lines, [2; 4]);
%!test
%! file = written ("a;b\n1,5;2\n");
%! [header, cells] = readCsvTable (file);
%! delete (file);
%! assert (cells, {'1.5', '2'});
%! file = written ("\"a\";\"b, c\"\n\"-1,5e-3\";\"x, y\"\n");
%! [header, cells] = readCsvTable (file);
%! delete (file);
%! assert (header, {'a', 'b, c'});
%! assert (cells, {'-1.5e-3', 'x, y'});
%!error id=DEcalioc:readCsvTable:missingFile readCsvTable ('/no/such/file')
%!error id=DEcalioc:readCsvTable:badShape
%! readCsvTable (written ("a,b\n1\n"));
%!error id=DEcalioc:readCsvTable:badShape readCsvTable (written (''));
