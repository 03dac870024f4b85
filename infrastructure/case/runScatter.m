% RUNSCATTER  What one run of a bench scatters by, and its mean.
%
% CALL: [SD, MEANS] = runScatter (FOLDER)
%
%   FOLDER  model folder that holds results.csv and scatter.csv (name, mean, sd)
%   SD, MEANS  1 x T, in the order of results.csv, at the values of data.head

function [sd, means] = runScatter (folder)
  [~, cells] = readCsvTable (fullfile (folder, 'scatter.csv'));
  values = str2double (cells(:, 2:3));
  names = {resultInfo(folder).name};
  [~, row] = ismember (names, cells(:, 1));
  means = values(row, 1)';
  sd = values(row, 2)';
end

%!test
%! root = fileparts (fileparts (which ('startToolbox')));
%! folder = fullfile (root, 'DEMmodels', 'Heap');
%! [sd, means] = runScatter (folder);
%! assert (size (sd), size (resultInfo (folder)));
%! assert (all (sd > 0) && means(1) > 20);
