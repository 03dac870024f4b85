% STARTTABLE  Begins a table of results, or goes on with it.
%
% CALL: [DONE, COUNTED] = startTable (FILE, COLUMNS, N)
%
%   FILE     path of the table
%   COLUMNS  text, its header, separated by commas
%   N        how many columns tell its rows apart (the first ones)
%   DONE     1 x m cell, these columns of the rows that stand in it, joined by
%            commas: what need not be made again
%   COUNTED  onCleanup: keep it until the last row is written; then the processor
%            time of this Octave and its children is added to the core-hours
%
% A new table begins with originLines; one that goes on gets call, commit and date of
% the program that goes on, where they differ.
%
% See also: appendLine, originLines, writeTable

function [done, counted] = startTable (file, columns, n)
  lines = originLines ();
  lines{5} = '# core-hours: 0';
  if isfile (file)
    [~, cells] = readCsvTable (file);
    done = cell (1, rows (cells));
    for i = 1:rows (cells)
      done{i} = strjoin (cells(i, 1:n), ',');
    end
    goOn (file, lines);
  else
    done = {};
    writeAtomic (file, [strjoin([lines, {columns}], "\n"), "\n"]);
  end
  before = processorSeconds ();
  counted = onCleanup (@() addHours (file, before));
end

function goOn (file, lines)
  [head, rest] = originOf (file);
  if isempty (head.commit)
    return
  end
  between = {'; ', ' ', ' '};
  for k = 1:3
    new = regexp (lines{k}, '^# (\w+): (.*)$', 'tokens', 'once');
    if isempty (strfind (head.(new{1}), new{2}))
      head.(new{1}) = [head.(new{1}), between{k}, new{2}];
    end
  end
  writeHead (file, head, rest);
end

function addHours (file, before)
  [head, rest] = originOf (file);
  hours = str2double (head.hours);
  if isfinite (hours)
    head.hours = sprintf ('%.3g', hours + (processorSeconds () - before) / 3600);
    writeHead (file, head, rest);
  end
end

function writeHead (file, head, rest)
  text = sprintf (['# program: %s\n# commit: %s\n# date: %s\n# machine: %s\n', ...
                   '# core-hours: %s\n'], head.program, head.commit, head.date, ...
                  head.machine, head.hours);
  writeAtomic (file, [text, rest]);
end

%!test
%! file = tempname ();
%! [done, counted] = startTable (file, 'name,seed,x', 2);
%! assert (done, {});
%! evalc ('appendLine (file, ''a,1,0.5'')');
%! clear counted
%! head = originOf (file);
%! assert (str2double (head.hours) >= 0 && ~isempty (head.commit));
%! text = strrep (fileread (file), head.commit, '1234567');
%! writeAtomic (file, strrep (text, ['hours: ', head.hours], 'hours: 2'));
%! [done, counted] = startTable (file, 'name,seed,x', 2);
%! clear counted
%! assert (done, {'a,1'});
%! again = originOf (file);
%! assert (again.commit, ['1234567 ', head.commit]);
%! assert (again.date, head.date);
%! assert (str2double (again.hours) >= 2);
%! assert (tableRows (file).x, '0.5');
%!test
%! % a table of before, without a head, stays as it is
%! file = tempname ();
%! writeAtomic (file, "name,x\na,1\n");
%! [done, counted] = startTable (file, 'name,x', 1);
%! clear counted
%! assert (done, {'a'});
%! assert (fileread (file), "name,x\na,1\n");

% SPDX-License-Identifier: GPL-3.0-only
