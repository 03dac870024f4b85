% READRESULTS  Reads the numbers that a run has printed into a file.
%
% CALL: VALUES = readResults (FILE, NAMES, SHARE)
%
%   FILE    text file in one of these forms:
%           as many numbers as there are NAMES, separated by blanks, commas or
%           new lines, in their order;
%           lines NAME VALUE, in any order, with blanks, a comma, = or :
%           between; of several lines of a name the last one counts; a VALUE
%           with a decimal comma is none;
%           rows of numbers below a line that names the columns (a csv, the
%           thermo output of a log, fix ave/time, fix print with a title), or
%           without one, with a column for each of the NAMES in their order,
%           perhaps behind one for the step
%   NAMES   1 x m cell of names of results; v_force, f_force and force [N] are
%           columns of force, too
%   SHARE   of rows: 0 (default) takes the last row, 0.2 the mean of the last
%           fifth, 1 of all
%   VALUES  1 x m, NaN where a result is missing; all NaN where the file is, or
%           where it holds another count of plain numbers
%
% See also: readSeries, readDump, readCsvTable, resultInfo
function values = readResults (file, names, share)
  if nargin < 3
    share = 0;
  end
  values = NaN (1, numel (names));
  text = readText (file);
  plain = sscanf (strrep (text, ',', ' '), '%f').';
  isPlain = isempty (regexp (text, '[^\s,\d.eE+-]', 'once')) || ...
            all (isnan (plain));
  if isPlain && numel (plain) == numel (names)
    values = plain;
    return
  end
  table = readSeries (text, names);
  for k = 1:numel (names)
    word = regexptranslate ('escape', names{k});
    found = regexp (text, ['^[ \t]*', word, '[ \t]*[ \t,=:][ \t]*(\S+)[ \t]*$'], ...
                    'tokens', 'lineanchors');
    if ~isempty (found)
      % str2double takes a comma for a separator of thousands
      values(k) = str2double (regexprep (found{end}{1}, '.*,.+', 'NaN'));
    elseif ~isempty (table)
      n = max (1, round (share * rows (table)));
      values(k) = mean (table(end - n + 1:end, k));
    end
  end
end

%!function values = tryText (text, varargin)
%!  file = tempname ();
%!  writeAtomic (file, text);
%!  values = readResults (file, varargin{:});
%!endfunction
%!assert (tryText ("1.5 -2e-3\n", {'a', 'b'}), [1.5, -2e-3])
%!assert (tryText ("1,2\n3", {'a', 'b', 'c'}), [1, 2, 3])
%!assert (tryText ("run-out = 3\na (m),1\nab 7\n", ...
%!                 {'a (m)', 'run-out', 'c'}), [1, 3, NaN])
%!assert (tryText ("slope 0,45\na 1,234.5\nb 2\n", {'slope', 'a', 'b'}), ...
%!        [NaN, NaN, 2])
%!assert (tryText ("1 2 3\n", {'a', 'b'}), [NaN, NaN])
%!assert (tryText ("1 2 3 4\n", {'a', 'b'}), [NaN, NaN])
%!assert (tryText ("nan 1\n", {'a', 'b'}), [NaN, NaN])
%!assert (readResults ('/nowhere', {'a'}), NaN)
%!assert (tryText ("mass 0.1\nprint \"mass ${m}\"\nmass 0.4\n", {'mass'}), 0.4)
%!assert (tryText ("t,force [N]\n0,1\n1,3\n2,5\n", {'force'}), 5)
%!assert (tryText ("t,force [N]\n0,1\n1,3\n2,5\n", {'force'}, 2/3), 4)

% SPDX-License-Identifier: GPL-3.0-only
