% WRITECALIBRATIONJSON  Writes results/calibration.json and tables beside it.
%
% CALL: writeCalibrationJson (C, CASE)
%
%   C     see newCalibration
%   CASE  see newCase
%
% sensitivity.csv holds total Sobol indices (one row a parameter, one column a
% target), correlation.csv the correlation of the parameters among the sets
% that fit. The fields are described in docs/data.md.
%
% See also: newCalibration

function writeCalibrationJson (c, Case)
  targets = cell (1, numel (Case.targets));
  surrogates = cell (1, numel (Case.targets));
  for t = 1:numel (Case.targets)
    T = Case.targets(t);
    targets{t} = struct ('model', T.modelName, 'name', T.name, ...
                         'role', T.role, 'target', T.value, 'sd', T.sd, ...
                         'result', c.results(t), ...
                         'residual', c.residual(t), 'noiseSd', c.runSd(t));
    s = c.surrogates(t);
    surrogates{t} = struct ('model', T.modelName, 'target', T.name, ...
                            'Q2', s.Q2, 'noiseSd', sqrt (s.noiseVar));
  end
  intervals = cell2struct (num2cell (c.interval90', 2), Case.names, 1);
  out = struct ('params', cell2struct (num2cell (c.params(:)), Case.names, 1));
  out.interval90 = intervals;
  out.targets = targets;
  out.converged = c.converged;
  out.reason = c.reason;
  out.demRuns = c.demRuns;
  out.coreSeconds = c.coreSeconds;
  out.atLimit = c.atLimit(:)';
  out.notIdentified = c.notIdentified(:)';
  out.surrogates = surrogates;
  writeTables (c, Case);
  folder = fullfile (Case.folder, 'results');
  [~, ~] = mkdir (folder);
  writeAtomic (fullfile (folder, 'calibration.json'), ...
               [jsonencode(out), "\n"]);
end

function writeTables (c, Case)
  folder = fullfile (Case.folder, 'results');
  [~, ~] = mkdir (folder);
  targets = strrep ({Case.targets.name}, ',', ';');
  writeMatrix (fullfile (folder, 'sensitivity.csv'), c.sensitivity, targets);
  writeMatrix (fullfile (folder, 'correlation.csv'), c.correlation, ...
               Case.names);
end
