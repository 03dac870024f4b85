% RESULTTABLE  Writes a table of benchmarks/results, with its origin on top.
%
% CALL: resultTable (NAME, COMMAND, COLUMNS, LINES [, PLACE])
%
%   NAME     of the file (text);  COMMAND  what has made it (text)
%   COLUMNS  their names, with commas (text);  LINES  1 x n cell of texts
%   PLACE    folder (default: benchmarks/results)
%
% Two lines before it say the command, the machine, the date and who worked.
%
% See also: twoUsers, appendLine

function resultTable (name, command, columns, lines, place)
  if nargin < 5
    place = fullfile (fileparts (which ('startBenchmarks')), 'results');
  end
  [~, cpu] = system ('sed -n "s/^model name.*: //p" /proc/cpuinfo | head -n 1');
  who = {'one user', 'two users'};
  head = sprintf ('# %s\n# %d x %s (load %.1f), Octave %s, %s, %s\n%s\n', ...
                  command, nproc (), strtrim (cpu), ...
                  sscanf (fileread ('/proc/loadavg'), '%f', 1), version (), ...
                  datestr (now (), 29), who{1 + (geteuid () == 0)}, columns);
  writeAtomic (fullfile (place, name), [head, sprintf('%s\n', lines{:})]);
end

%!test
%! resultTable ('a.csv', 'run it', 'x,y', {'1,2', '3,4'}, tempdir ());
%! lines = strsplit (fileread (fullfile (tempdir (), 'a.csv')), "\n");
%! assert (lines([1, 3:5]), {'# run it', 'x,y', '1,2', '3,4'});
%! unlink (fullfile (tempdir (), 'a.csv'));
