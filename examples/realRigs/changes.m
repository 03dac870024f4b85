% CHANGES  What changed in each reading of the real rigs, and how well it is known.
%
% CALL: octave-cli examples/realRigs/changes.m
%
% Prints the table changes.csv, but for its column sdBefore: rig, series, quantity,
% change (of the value, series 1 being the reference), sd (68 %, of both series
% together; less what both owe to the same sessions), freedom. No model takes part:
% the readings alone.
%
% See also: sdOfChange, varianceComponents

1;

function sayRig (folder)
  root = fileparts (mfilename ('fullpath'));
  models = dir (fullfile (root, folder, 'DEMmodels'));
  models = models([models.isdir] & ~strncmp ({models.name}, '.', 1));
  folders = fullfile (root, folder, 'DEMmodels', {models.name});
  models = struct ('name', {models.name}, 'folder', folders);
  lines = readMeasured (fullfile (root, folder, 'measured.csv'), {models.name});
  lines = contrastLines (checkUnits (lines, models), models);
  [groups, ~, conditions] = groupMeasured (lines, {models.name});
  for c = 1:numel (conditions)
    for g = groups
      now = g.changed(c);
      if ~isfinite (now.value - g.value)
        continue
      end
      [sd, freedom] = sdOfChange (g, now);
      printf ("%s,%s,%s,%.4g,%.2g,%.3g\n", folder, conditions{c}, g.name, ...
              now.value - g.value, sd, min (freedom, 999));
    end
  end
end

root = fileparts (fileparts (fileparts (mfilename ('fullpath'))));
addpath (fullfile (root, 'infrastructure'));
startToolbox (root);
printf ("rig,series,quantity,change,sd,freedom\n");
for rig = {'doser/P', 'doser/Q', 'doser/R', 'liquid_columns', 'ring_shear'}
  sayRig (rig{1});
end

% SPDX-License-Identifier: GPL-3.0-only
