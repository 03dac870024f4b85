% PAGEGAPCASE  Makes the folder of a finished diagnosis, without DEM.
%
% CALL: CASE = pageGapCase (FOLDER)
%
%   FOLDER  folder to be made (text)
%   CASE    see newCase: examples/hiddenEffect, with hiddenEffect.json of this
%           folder as its gap.json, with measured values that give its misses
%
% See also: pageCase

function Case = pageGapCase (folder)
  root = fileparts (fileparts (mfilename ('fullpath')));
  mkdir (folder);
  mkdir (fullfile (folder, 'gap'));
  example = fullfile (root, 'examples', 'hiddenEffect');
  copyfile (fullfile (example, '*.m'), folder);
  copyfile (fullfile (root, 'tests', 'hiddenEffect.json'), ...
            fullfile (folder, 'gap', 'gap.json'));
  copyfile (fullfile (example, 'storedRuns.csv'), ...
            fullfile (folder, 'runs.csv'));
  addpath (folder);
  tidy = onCleanup (@() rmpath (folder));
  raw = struct ('root', root, 'folder', folder);
  [raw.Input, raw.optim, raw.modelVars, raw.assign, raw.paramLims] = ...
    loadInput ();
  raw.Input.maxNewRuns = 0;
  Case = withEffects (newCase (raw));
  writeTargets (Case);
end

function writeTargets (Case)
  file = fullfile (Case.folder, 'gap', 'gap.json');
  gap = jsondecode (fileread (file));
  for t = 1:numel (gap.where.targets)
    T = Case.targets(t);
    gap.where.targets(t).measured = T.value;
    gap.where.targets(t).predicted = T.value - gap.where.targets(t).z * 2 * T.sd;
    [gap.where.targets(t).sdMeasured, gap.where.targets(t).sdPredicted] = deal (T.sd);
  end
  writeAtomic (file, jsonencode (gap));
end

% SPDX-License-Identifier: GPL-3.0-only
