% RUNSCATTER  What one run of a bench scatters by, and its mean.
%
% CALL: [SD, MEANS, RUNS] = runScatter (FOLDER)
%
%   FOLDER  model folder that holds results.csv and scatter.csv (name, mean, sd;
%           runs: of so many packings, without this column 8)
%   SD, MEANS, RUNS  1 x T, in the order of results.csv, at the values of
%           data.head; NaN of a result that scatter.csv does not name
%
% Errors: DEcalioc:runScatter:badValue, those of readCsvTable

function [sd, means, runs] = runScatter (folder)
  file = fullfile (folder, 'scatter.csv');
  [header, cells] = readCsvTable (file);
  values = str2double (cells(:, 2:end));
  if numel (header) < 4
    values(:, 3) = 8;
  end
  isGood = isfinite (values(:, 1)) & values(:, 2) >= 0 & values(:, 3) >= 2;
  if ~all (isGood)
    bad = find (~isGood, 1);
    error ('DEcalioc:runScatter:badValue', ...
           ['runScatter: %s must have a mean, an sd of 0 or more and 2 or more runs ' ...
            'for each result, got %s. Correct it, or remove the file: it only makes ' ...
            'calibrations shorter.'], file, strjoin (cells(bad, :), ','));
  end
  [has, row] = ismember ({resultInfo(folder).name}, cells(:, 1));
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
