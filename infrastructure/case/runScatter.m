% RUNSCATTER  What one run of a bench scatters by, and its mean.
%
% CALL: [SD, MEANS, RUNS] = runScatter (FOLDER)
%
%   FOLDER  model folder that holds results.csv and scatter.csv (columns name, mean,
%           sd, in any order; runs: of so many packings, without this column 8)
%   SD, MEANS, RUNS  1 x T, in the order of results.csv, at the values of
%           data.head; NaN of a result that scatter.csv does not name
%
% Errors: DEcalioc:runScatter:badValue, :unknownName, :missingFile, those
% of readCsvTable

function [sd, means, runs] = runScatter (folder)
  file = fullfile (folder, 'scatter.csv');
  info = resultInfo (folder);
  if isempty (info)
    error ('DEcalioc:runScatter:missingFile', ...
           ['runScatter: %s needs a results.csv beside it, which names the results, got ' ...
            'none. Write it (docs/extend.md).'], file);
  end
  [header, cells] = readCsvTable (file);
  [isThere, at] = ismember ({'name', 'mean', 'sd', 'runs'}, lower (header));
  if ~all (isThere(1:3))
    error ('DEcalioc:runScatter:badValue', ...
           ['runScatter: %s must have the columns name, mean and sd, got %s.' ...
            ' Correct it.'], file, strjoin (header, ','));
  end
  values = 8 * ones (rows (cells), 3);
  values(:, isThere(2:4)) = str2double (cells(:, at([false, isThere(2:4)])));
  isGood = isfinite (values(:, 1)) & values(:, 2) >= 0 & values(:, 3) >= 2;
  if ~all (isGood)
    bad = find (~isGood, 1);
    error ('DEcalioc:runScatter:badValue', ...
           ['runScatter: %s must have a mean, an sd of 0 or more and 2 or more runs ' ...
            'for each result, got %s. Correct it.'], file, strjoin (cells(bad, :), ','));
  end
  known = {info.name};
  unknown = setdiff (cells(:, at(1)), known);
  if ~isempty (unknown)
    error ('DEcalioc:runScatter:unknownName', ...
           'runScatter: %s must name results of results.csv, %s; got ''%s''. %s', file, ...
           strjoin (known, ', '), unknown{1}, checkNearest (unknown{1}, known));
  end
  [has, row] = ismember (known, cells(:, at(1)));
  list = NaN (numel (has), 3);
  list(has, :) = values(row(has), :);
  [means, sd, runs] = deal (list(:, 1)', list(:, 2)', list(:, 3)');
end

%!test
%! root = fileparts (fileparts (which ('startToolbox')));
%! folder = fullfile (root, 'DEMmodels', 'Heap');
%! [sd, means, runs] = runScatter (folder);
%! assert (size (sd), size (resultInfo (folder)));
%! assert (all (sd > 0) && means(1) > 20 && all (runs == 8));
%!test
%! % columns by their names; what is not understood is said, not left out
%! root = fileparts (fileparts (which ('startToolbox')));
%! folder = emptyFolder ();
%! copyfile (fullfile (root, 'DEMmodels', 'Heap', 'results.csv'), folder);
%! says = @(text) writeAtomic (fullfile (folder, 'scatter.csv'), text);
%! says ("SD, runs, name, mean\n1, 4, slope, 30\n");
%! [sd, means, runs] = runScatter (folder);
%! assert ({sd(1), means(1), runs(1), isnan(sd(2))}, {1, 30, 4, true});
%! for fault = {"name,mean,sd\nslop,30,1\n", 'unknownName'; ...
%!              "name,mean\nslope,30\n", 'badValue'; ...
%!              "name,mean,sd\nslope,30,-1\n", 'badValue'; ...
%!              "name,mean,sd,runs\nslope,30,1,1\n", 'badValue'}'
%!   says (fault{1});
%!   id = '';
%!   try
%!     runScatter (folder);
%!   catch err
%!     id = err.identifier;
%!   end
%!   assert (id, ['DEcalioc:runScatter:', fault{2}]);
%! end
%! unlink (fullfile (folder, 'results.csv'));
%! fail ('runScatter (folder)', 'needs a results.csv');

% SPDX-License-Identifier: GPL-3.0-only
