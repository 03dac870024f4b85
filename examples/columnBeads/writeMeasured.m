% WRITEMEASURED  Writes measured.csv from trials.csv and profiles.csv.
%
% CALL: octave-cli writeMeasured.m
%
% One line a series and reading: the mean of its trials, and for its standard
% uncertainty what a trial scatters by within all series, over the root of their
% number. Series 1 is the reference. The profile is taken at 0.05 to 0.95 of the
% length of the tank; between two of the 50 places their mean. Left out are the
% heights of 4 mm (read about 1 cm low in series 1; only predicted), and the
% length of 4 mm, series 1, trial 1: the whole tank.
%
% See also: loadInput, seriesMeans

1;

function lines = linesOf (Case, folder, series, condition)
  [value, n, sd] = seriesMeans (Case, folder, series);
  lines = {};
  for t = 1:numel (Case.targets)
    own = Case.targets(t);
    name = own.result;
    place = '';
    if own.curve > 0
      name = '';
      place = sprintf ('%.2f', own.at);
    end
    if strcmp (name, 'height') && strcmp (own.modelName, 'Beads4')
      continue
    end
    lines{end + 1} = sprintf ('%s,%s,%s,%s,%s,%.6g,%.3g,Inf,%g abs', ...
                              condition, own.modelName, name, own.series, ...
                              place, value(t), sd(t) / sqrt (n(t)), own.tol);
  end
end

function result = writeTable (root, folder)
  useLiggghts (root);
  addpath (folder);
  names = {'reference', 'series2', 'series3', 'series4'};
  Case = loadCase (root, folder);
  lines = {'condition,model,name,series,at,value,sd,repeats,tol', ...
           'reference,Beads4,height,,,,0.3,,0.5 abs'};
  for k = 1:4
    lines = [lines, linesOf(Case, folder, k, names{k})];
  end
  writeAtomic (fullfile (folder, 'measured.csv'), sprintf ("%s\n", lines{:}));
  result.exitStatus = 0;
end

here = fileparts (mfilename ('fullpath'));
root = fileparts (fileparts (here));
addpath (fullfile (root, 'infrastructure'));
startMain (@writeTable, root);

% SPDX-License-Identifier: GPL-3.0-only
