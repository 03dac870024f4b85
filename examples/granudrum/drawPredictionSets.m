% DRAWPREDICTIONSETS  Writes the parameter sets that predictSurfaces.m runs.
%
% CALL: octave-cli drawPredictionSets.m [nearest]
%
% From the runs without effects that there are: predictionSets.csv, with the set
% nearest to the measured surfaces over both speeds (mean of its packings, four
% packings wanted) and 8 sets of the posterior of the parameters. Packing 0: a
% set of the posterior, run once. The rows stand in the order in which they are
% worth their run. With "nearest" the five nearest sets that were run at the
% last level stand there instead, two packings of the nearest one: where few
% runs of that level leave the posterior in a corner that nobody has looked at.
%
% See also: predictSurfaces, parameterPosterior

1;

% Sets that were run, the nearest one first.
function X = nearestSets (data, y)
  [X, ~, which] = unique (data.X, 'rows');
  miss = zeros (rows (X), 1);
  for k = 1:rows (X)
    miss(k) = sumsq (mean (data.Z(which == k, :), 1) - y);
  end
  [~, order] = sort (miss);
  X = X(order, :);
end

function result = drawCase (root, folder)
  useLiggghts (root);
  Case = withEffects (loadCase (root, folder));
  everyTarget = true (1, numel (Case.targets));
  [surrogates, problem, data] = neutralSurrogates (Case, everyTarget);
  X = nearestSets (data, [Case.targets.value]);
  centre = X(1, :);
  sample = parameterPosterior (surrogates, problem, 400).sample;
  P = sample(round (linspace (1, rows (sample), 8)), :);
  table = [1, centre; 2, centre; zeros(8, 1), P; 3, centre; 4, centre];
  if any (strcmp (argv (), 'nearest'))
    table = [1, centre; 2, centre; zeros(4, 1), X(2:5, :)];
  end
  lines = cell (1, rows (table));
  for i = 1:rows (table)
    lines{i} = sprintf ('%.10g,%.10g,%.10g,%.10g', table(i, :));
  end
  lines = [{['packing,', strjoin(Case.names, ',')]}, lines];
  writeAtomic (fullfile (folder, 'predictionSets.csv'), ...
               sprintf ('%s\n', lines{:}));
  sorted = sort (sample);
  ends = sorted(round ([0.05; 0.95] * rows (sample)), :);
  for j = 1:numel (Case.names)
    printf ('%s: nearest %.3f, 90 %% of the sets that fit %.3f to %.3f\n', ...
            Case.names{j}, centre(j), ends(:, j));
  end
  result.exitStatus = 0;
end

here = fileparts (mfilename ('fullpath'));
root = fileparts (fileparts (here));
addpath (fullfile (root, 'infrastructure'), here);
startMain (@drawCase, root);

% SPDX-License-Identifier: GPL-3.0-only
