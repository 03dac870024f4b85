% MWELEDGER  Finished runs of one attempt of the benchmark mwe.
%
% CALL: RUNS = mweLedger (FILE, KEY)
%       mweLedger (FILE, KEY, ROW)      adds one run
%
% FILE  text, benchmarks/results/mweRuns.csv; made if it is not there
% KEY   text, the attempt: scale,repetition,method,attempt
% ROW   1 x (d + T + 2): replicate, parameters, results (NaN: failed run),
%       seconds of user time
% RUNS  n x (d + T + 2), in the order of the runs; 0 x 1 if there are none
%
% A run of the published tool takes minutes and an attempt of it hours: what is
% in this file is not run again, on whatever machine the benchmark goes on.
%
% See also: mwe, mweAttempt

function runs = mweLedger (file, key, row)
  if nargin > 2
    [id, message] = fopen (file, 'a');
    if id < 0
      error ('DEcalioc:mweLedger:runFailed', ...
             'mweLedger: FILE must be writable, got %s: %s.', file, message);
    end
    if ftell (id) == 0
      fprintf (id, ['scale,repetition,method,attempt,replicate,densityP,', ...
                    'coefFrictionPP,coefFrictionPW,coefRollingFrictionPP,', ...
                    'coefRollingFrictionPW,density,mass,seconds,processor\n']);
    end
    % one write, so that two benchmarks at a time do not mix their lines
    fprintf (id, '%s', [key, sprintf(',%.17g', row), ',', processor(), "\n"]);
    fclose (id);
    return
  end
  runs = zeros (0, 1);
  if isfile (file)
    lines = regexp (fileread (file), ['^', key, ',([^\n]*),[^,\n]*$'], ...
                    'tokens', 'lineanchors');
    numbers = cellfun (@(l) str2double (strsplit (l{1}, ',')), lines(:), ...
                       'UniformOutput', false);
    runs = vertcat (zeros (0, 1), numbers{:});
  end
end

function name = processor ()
  [~, text] = system ('grep -m 1 "model name" /proc/cpuinfo');
  name = strtrim (strrep (regexprep (text, '^[^:]*:', ''), ',', ' '));
end

%!test
%! file = tempname ();
%! assert (rows (mweLedger (file, 'default,1,published,1')), 0);
%! mweLedger (file, 'default,1,published,1', [1, 1 / 3, 2, 5]);
%! mweLedger (file, 'default,2,published,1', [1, 7, 2, 5]);
%! mweLedger (file, 'default,1,published,1', [2, 0.1, NaN, 6]);
%! runs = mweLedger (file, 'default,1,published,1');
%! delete (file);
%! assert (isequaln (runs, [1, 1 / 3, 2, 5; 2, 0.1, NaN, 6]));
