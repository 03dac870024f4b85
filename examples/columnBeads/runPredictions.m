% RUNPREDICTIONS  Runs the causes of the verdict with beads of 4 to 10 mm.
%
% CALL: octave-cli runPredictions.m [NEW [SETS]]
%
% NEW   DEM runs that may be made of each table (0: only those of the store)
% SETS  of each line of sealedCauses.csv (5)
%
% Each line of sealedCauses.csv gets the same SETS sets of parameters that fit series
% 1 (results/posterior.csv), with the cause at strengths over its interval.
% Writes predictionSets.csv (line of sealedCauses.csv, parameters, variables of the
% effects), predictionRuns.csv (4 and 8 mm), predictionRuns6.csv and
% predictionRuns10.csv.
%
% See also: predictBeads, diagnoseChange

1;

function [line, P, E] = plannedSets (Case, folder, n)
  [~, cells] = readCsvTable (fullfile (folder, 'results', 'posterior.csv'));
  theta = str2double (cells);
  at = round (linspace (1, rows (theta), n + 2));
  theta = theta(at(2:end - 1), :);
  [~, causes] = readCsvTable (fullfile (folder, 'sealedCauses.csv'));
  effects = [];
  for e = Case.effects(~[Case.effects.laboratory])
    given = struct ('name', e.name, 'variables', {e.variables}, ...
                    'neutral', e.neutral, 'limits', e.limits);
    effects = [effects, newEffect(given, numel (Case.targets))];
  end
  line = repelem ((1:rows (causes))', n);
  P = repmat (theta, rows (causes), 1);
  Phi = zeros (rows (P), numel (effects));
  for i = 1:rows (causes)
    k = strcmp ({effects.name}, causes{i, 2});
    if any (k)
      q = str2double (causes(i, 5:7));
      phi = q(1) + diff (q(2:3)) / 3.29 * linspace (-1.2, 1.2, n)';
      range = effects(k).range;
      % strong and weak in an order that does not follow that of the sets
      phi = phi(mod (2 * (0:n - 1), n) + 1);
      Phi(line == i, k) = min (max (phi, range(1)), range(2));
    end
  end
  E = valuesOfStrength (effects, Phi);
end

% 0: 4 and 8 mm. Else the model of 8 mm with grains of MM.
function runSize (Case, folder, P, E, mm, nNew)
  file = 'predictionRuns.csv';
  if mm > 0
    file = sprintf ('predictionRuns%d.csv', mm);
    Case.models = Case.models(1);
    Case.targets = Case.targets([Case.targets.model] == 1);
    Case.modelVars.grainSize = mm;
    Case.store = fullfile (folder, 'results', 'prediction');
    [~, ~] = mkdir (Case.store);
  end
  Case.options.maxNewRuns = nNew;
  [X, first] = unique ([P, E], 'rows', 'stable');
  d = columns (P);
  Z = evaluateDEM (X(:, 1:d), Case, 1, 'gap', ...
                   newProgress (sprintf ('%d mm', mm), @disp), ...
                   X(:, d + 1:end));
  there = any (isfinite (Z), 2);
  data = struct ('X', X(there, 1:d), 'E', X(there, d + 1:end), ...
                 'Z', Z(there, :), 'replicate', ones (sum (there), 1));
  n = exportRuns (fullfile (folder, file), Case, data);
  printf ('%s: %d runs of %d sets\n', file, n, rows (X));
end

function result = runCase (root, folder)
  useLiggghts (root);
  addpath (folder);
  given = {0, 5};
  words = argv ();
  given(1:numel (words)) = num2cell (str2double (words));
  [nNew, n] = given{:};
  Case = withEffects (loadCase (root, folder));
  [line, P, E] = plannedSets (Case, folder, n);
  form = [strjoin(repmat ({'%.10g'}, 1, 1 + columns ([P, E])), ','), "\n"];
  header = strjoin ([{'line'}, Case.names, Case.effectVars], ',');
  writeAtomic (fullfile (folder, 'predictionSets.csv'), ...
               [header, "\n", sprintf(form, [line, P, E]')]);
  for mm = [0, 10, 6]
    runSize (Case, folder, P, E, mm, nNew);
  end
  result.exitStatus = 0;
end

here = fileparts (mfilename ('fullpath'));
root = fileparts (fileparts (here));
addpath (fullfile (root, 'infrastructure'));
startMain (@runCase, root);

% SPDX-License-Identifier: GPL-3.0-only
