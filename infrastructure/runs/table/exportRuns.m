% EXPORTRUNS  Writes finished runs as a table runs.csv for other programs.
%
% CALL: N = exportRuns (FILE, CASE, DATA)
%
%   FILE   path of the table; replaced at once when it is complete, and left as it is
%          where there is nothing to write: it may be all that is left of the runs
%   CASE   struct with names, effectVars, targets, models, options.seed
%   DATA   struct X (n x d), E (n x v), Z (n x T), replicate (n x 1); optional
%          ended (n x M logical, the simulation of that model ran to its end)
%          and seed (n x M, of the runs, where one was tried with another seed)
%   N      scalar, rows written: one for each model and row of DATA that has a
%          result, or has ended without one (a bin that jams): its fields are
%          empty then; reading gives the same bits (exactNumber)
%
% Columns: model, seed, design variables, effect variables, targets. importRuns
% reads the file back.

function n = exportRuns (file, Case, data)
  lines = {csvLine([{'model', 'seed'}, Case.names, Case.effectVars, ...
                    {Case.targets.name}])};
  data = completed (data, Case);
  for i = 1:rows (data.X)
    for k = 1:numel (Case.models)
      z = data.Z(i, :);
      z([Case.targets.model] ~= k) = NaN;
      if data.ended(i, k) || any (isfinite (z))
        numbers = num2cell ([data.seed(i, k), data.X(i, :), data.E(i, :), z]);
        lines{end + 1} = csvLine ([{Case.models(k).name}, numbers]);
      end
    end
  end
  n = numel (lines) - 1;
  if n > 0 || ~isfile (file)
    writeAtomic (file, [strjoin(lines, "\n"), "\n"]);
  end
end

function data = completed (data, Case)
  shape = [rows(data.X), numel(Case.models)];
  if ~isfield (data, 'ended')
    data.ended = false (shape);
  end
  if ~isfield (data, 'seed')
    data.seed = zeros (shape);
    for i = 1:shape(1)
      data.seed(i, :) = runSeed (data.X(i, :), data.replicate(i), ...
                                 Case.options.seed);
    end
  end
end

%!function Case = small ()
%!  Case.names = {'mu', 'rho'};
%!  Case.effectVars = {'coh'};
%!  Case.effects = struct ('name', 'c', 'neutral', 0);
%!  Case.coarse = [];
%!  Case.models = struct ('name', {'Drum', 'Heap'});
%!  Case.targets = struct ('name', {'slope', 'area', 'angle'}, ...
%!                         'model', {1, 1, 2});
%!  Case.options.seed = 1;
%!endfunction
%!function [back, file] = thereAndBack (data, n)
%!  file = tempname ();
%!  assert (exportRuns (file, small (), data), n);
%!  back = importRuns (file, small ());
%!  for name = {'X', 'E', 'Z', 'replicate'}
%!    assert (isequaln (back.(name{1}), data.(name{1})), name{1});
%!  end
%!endfunction
%!test
%! % there and back: same bits, replicates and holes kept
%! data.X = [0.1, 700; 0.1, 700; toDigits([1 / 3, pi])];
%! data.E = [0; 0; 1e4];
%! data.Z = [1, 2, 3; 1.5, NaN, NaN; 4, 5, 6 + eps(6)];
%! data.replicate = [1; 2; 1];
%! thereAndBack (data, 5);
%!test
%! % a run that ended without results is a row of empty fields, one that broke
%! % off is none; partly empty rows and seeds of second tries are kept
%! data.X = [1, 2; 1, 2; 3, 4];
%! data.E = [0; 0; 5];
%! data.Z = [1, NaN, 3; 1, 2, NaN; NaN, NaN, NaN];
%! data.replicate = [1; 2; 1];
%! data.ended = [true, true; true, false; true, true];
%! data.seed = [10007, 10007; 10009, 10009; 10037, 10039];
%! [~, file] = thereAndBack (data, 5);
%! [~, cells] = readCsvTable (file);
%! assert (cells(4, :), {'Drum', '10037', '3', '4', '5', '', '', ''});
%! assert (cells{5, 2}, '10039');
%!test
%! % a table that is there may be all that is left
%! none = struct ('X', zeros (0, 2), 'E', zeros (0, 1), 'Z', zeros (0, 3), ...
%!                'replicate', zeros (0, 1));
%! file = tempname ();
%! writeAtomic (file, "kept\n");
%! assert (exportRuns (file, small (), none), 0);
%! assert (fileread (file), "kept\n");
%!error id=DEcalioc:writeAtomic:cannotWrite
%! data = struct ('X', zeros (0, 2), 'E', zeros (0, 1), 'Z', zeros (0, 3));
%! data.replicate = zeros (0, 1);
%! exportRuns ('/no/such/folder/runs.csv', small (), data);

% SPDX-License-Identifier: GPL-3.0-only
