% READRESULTS  Reads the numbers that a run has printed into a file.
%
% CALL: VALUES = readResults (FILE, NAMES)
%
%   FILE    text file: as many numbers as there are NAMES, separated by blanks,
%           commas or new lines, in their order; or lines NAME VALUE, in any
%           order, with blanks, a comma, = or : between; a VALUE with a
%           decimal comma is none
%   NAMES   1 x m cell of names of results
%   VALUES  1 x m, NaN where a result is missing; all NaN where the file is, or
%           where it holds another count of plain numbers
%
% See also: readDump, readCsvTable, resultInfo
function values = readResults (file, names)
  values = NaN (1, numel (names));
  text = readText (file);
  plain = sscanf (strrep (text, ',', ' '), '%f').';
  isPlain = isempty (regexp (text, '[^\s,\d.eE+-]', 'once')) || ...
            all (isnan (plain));
  if isPlain && numel (plain) == numel (names)
    values = plain;
    return
  end
  for k = 1:numel (names)
    word = regexptranslate ('escape', names{k});
    found = regexp (text, ['^[ \t]*', word, '[ \t]*[ \t,=:][ \t]*(\S+)'], ...
                    'tokens', 'once', 'lineanchors');
    if ~isempty (found)
      % str2double takes a comma for a separator of thousands
      values(k) = str2double (regexprep (found{1}, '.*,.+', 'NaN'));
    end
  end
end

%!function values = tryText (text, names)
%!  file = tempname ();
%!  writeAtomic (file, text);
%!  values = readResults (file, names);
%!endfunction
%!assert (tryText ("1.5 -2e-3\n", {'a', 'b'}), [1.5, -2e-3])
%!assert (tryText ("1,2\n3", {'a', 'b', 'c'}), [1, 2, 3])
%!assert (tryText ("run-out = 3\na (m),1\nab 7\n", ...
%!                 {'a (m)', 'run-out', 'c'}), [1, 3, NaN])
%!assert (tryText ("slope 0,45\na 1,234.5\nb 2\n", {'slope', 'a', 'b'}), ...
%!        [NaN, NaN, 2])
%!assert (tryText ("1 2 3\n", {'a', 'b'}), [NaN, NaN])
%!assert (tryText ("nan 1\n", {'a', 'b'}), [NaN, NaN])
%!assert (readResults ('/nowhere', {'a'}), NaN)
