% DRAWPREDICTIONSETS  Writes the parameter sets that predictSurfaces.m runs.
%
% CALL: octave-cli drawPredictionSets.m
%
% After DEcalioc.m and diagnoseGap.m. Writes predictionSets.csv, for the null
% model and for the one with the effect of the diagnosis: the calibrated set (4
% packings) and 8 of the sample of sets that fit (results/posterior.csv; with
% the effect the same deviations about its own calibrated set, and strengths
% drawn evenly over their 90 % interval). The model with the effect is called
% after it where the diagnosis names it, else best. predictionMiss.csv: rms of
% z at 15 and 45 rpm in mm that each of the two sets leaves, mean of its DEM
% runs (with the effect: those of the cure), where there are none NaN.
%
% See also: predictSurfaces

1;

function lines = setLines (model, centre, sample)
  lines = {};
  text = @(values) sprintf (',%.6g', values);
  for packing = 1:4
    lines{end + 1} = sprintf ('%s,%d%s', model, packing, text (centre));
  end
  for i = 1:rows (sample)
    lines{end + 1} = sprintf ('%s,0%s', model, text (sample(i, :)));
  end
end

% 8 sets about the calibrated one, inside the limits.
function P = sampleSets (folder, Case, centre)
  table = dlmread (fullfile (folder, 'results', 'posterior.csv'), ',', 1, 0);
  pick = round (linspace (1, rows (table), 8));
  P = table(pick, :) - mean (table, 1) + centre;
  P = min (max (P, Case.limits(1, :)), Case.limits(2, :));
end

function rms = missOf (Z, y)
  D2 = (mean (Z, 1) - y).^2;
  n = numel (y) / 2;
  rms = sqrt ([mean(D2(1:n)), mean(D2(n + 1:end))]);
end

% Results of the runs that verified the cure with this variable switched on.
function Z = cureRuns (Case, variable)
  Z = zeros (0, numel (Case.targets));
  model = Case.models(1).name;
  at = strcmp (Case.effectVars, variable);
  neutral = neutralEffects (Case);
  for name = listRunFolders (Case.store, model)
    record = readRecord (fullfile (Case.store, 'optim', model, name{1}, ...
                                   'record.json'));
    if isfield (record, 'stage') && strcmp (record.stage, 'cure') && ...
       strcmp (record.status, 'ok') && record.effects(at) ~= neutral(at)
      Z(end + 1, :) = record.results([Case.targets.index]);
    end
  end
end

function result = drawCase (root, folder)
  startToolbox (root, folder);
  useLiggghts (root);
  Case = withEffects (loadCase (root, folder));
  y = [Case.targets.value];
  found = jsondecode (fileread (fullfile (folder, 'results', ...
                                          'calibration.json')));
  centre = cellfun (@(name) found.params.(name), Case.names);
  lines = {['model,packing', sprintf(',%s', Case.names{:})]};
  missed = {'model,missedSlow,missedFast', ...
            sprintf('null,%.3f,%.3f', missOf ([found.targets.result], y))};
  null = sampleSets (folder, Case, centre);
  result.exitStatus = 0;
  gap = jsondecode (fileread (fullfile (folder, 'gap', 'gap.json')));
  effect = gap.howFar.effect;
  at = find (strcmp ({Case.effects.name}, effect));
  if isempty (at) || Case.effects(at).laboratory
    lines = [lines, setLines('null', centre, null)];
  else
    variable = Case.effects(at).variables{1};
    neutral = Case.effects(at).neutral(1);
    lines{1} = [lines{1}, ',', variable];
    lines = [lines, setLines('null', [centre, neutral], ...
                             [null, neutral * ones(rows (null), 1)])];
    name = 'best';
    if strcmp (gap.which.verdict, 'named')
      name = effect;
    end
    own = cellfun (@(name) gap.howFar.params.(name)(2), Case.names);
    strength = gap.which.strength.(effect).(variable);
    part = linspace (strength(2), strength(3), 8)';
    lines = [lines, setLines(name, [own, strength(1)], ...
                             [sampleSets(folder, Case, own), part])];
    missed{end + 1} = sprintf ('%s,%.3f,%.3f', name, ...
                               missOf (cureRuns (Case, variable), y));
  end
  writeAtomic (fullfile (folder, 'predictionSets.csv'), ...
               sprintf ('%s\n', lines{:}));
  writeAtomic (fullfile (folder, 'predictionMiss.csv'), ...
               sprintf ('%s\n', missed{:}));
end

here = fileparts (mfilename ('fullpath'));
root = fileparts (fileparts (here));
addpath (fullfile (root, 'infrastructure'), ...
         fullfile (root, 'infrastructure', 'case'));
startMain (@drawCase, root);
