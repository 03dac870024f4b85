% TABLEOFFOLDER  Makes a table runs.csv of a folder of finished simulations.
%
% CALL: N = tableOfFolder (FOLDER, FILE)
%
%   FOLDER  text; each folder in it is a simulation: its data.head with the
%           values of that run, and what the run wrote
%   FILE    text, the table that is written
%   N       number of rows; a simulation that is not sane is a row whose
%           targets are empty, for the calibration learns from it too
%
% Called in the folder of a case of one model: its loadInput.m names parameters
% and targets, its model reads the simulations.
%
% See also: importRuns, namedResults
function n = tableOfFolder (folder, file)
  root = fileparts (fileparts (which ('startToolbox')));
  Case = loadCase (root, pwd ());
  model = Case.models(1).folder;
  before = addpath (fullfile (model, 'OctaveFuns'));
  tidy = onCleanup (@() path (before));
  heads = glob (fullfile (folder, '*', 'data.head'));
  lines = {strjoin([{'seed'}, Case.names, {Case.targets.name}], ',')};
  for k = 1:numel (heads)
    values = headDefaults (heads{k});
    results = resultsOf (fileparts (heads{k}), model);
    texts = cellfun (@(x) sprintf ('%.9g', x), ...
                     [{values.runSeed}, ...
                      cellfun(@(n) values.(n), Case.names, ...
                              'UniformOutput', false), results], ...
                     'UniformOutput', false);
    lines{end + 1} = strrep (strjoin (texts, ','), 'NaN', '');
  end
  n = numel (heads);
  writeAtomic (file, sprintf ("%s\n", lines{:}));
end

% A simulation that ended early lacks a file: it has no results. What else
% measureBench throws is a slip in it.
function results = resultsOf (folder, model)
  try
    results = namedResults (@measureBench, folder, model);
  catch err
    if isempty (regexp (err.identifier, ':missingFile$', 'once'))
      rethrow (err);
    end
    results = num2cell (NaN (1, numel (resultInfo (model))));
  end
end

% SPDX-License-Identifier: GPL-3.0-only
