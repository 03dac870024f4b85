% PAGEGAPCASE  Makes the folder of a finished diagnosis, without DEM.
%
% CALL: CASE = pageGapCase (FOLDER)
%
%   FOLDER  folder to be made (text)
%   CASE    see newCase: examples/hiddenEffect, with hiddenEffect.json of this
%           folder as its gap.json; gap/targets.csv is made of it
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
  targets = jsondecode (fileread (file)).where.targets;
  lines = {['model,target,role,measured,predicted,residual,z,p,', ...
            'sd_measured,sd_trial,sd_surrogate']};
  for t = 1:numel (targets)
    T = Case.targets(t);
    miss = targets(t).z * 2 * T.sd;
    lines{end + 1} = sprintf ('%s,%s,%s,%.10g,%.10g,%.10g,%g,%g,%g,%g,%g', ...
                              T.modelName, T.name, T.role, T.value, ...
                              T.value - miss, miss, targets(t).z, ...
                              targets(t).p, T.sd, T.sd, T.sd);
  end
  writeAtomic (fullfile (Case.folder, 'gap', 'targets.csv'), ...
               [strjoin(lines, "\n"), "\n"]);
end
