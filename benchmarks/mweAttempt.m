% MWEATTEMPT  One attempt of the benchmark mwe, in the folder of its case.
%
% CALL: octave-cli mweAttempt.m METHOD LIMIT      in the folder of mweCase
%
% METHOD  'ours' or 'published'
% LIMIT   core minutes that the published tool may spend
%
% Calibrates, runs the set that is handed back with 5 further packings, and
% writes attempt.csv: runs, failed runs, core minutes, mean residual of each
% target, confirmed (1 or 0). Without a set the residuals are NaN. All finished
% runs are left in all-runs.csv.
%
% See also: mwe, mweCase, publishedMethod

1;

function attempt (root, method, limit)
  folder = pwd ();
  startToolbox (root, folder);
  useLiggghts (root);
  Case = loadCase (root, folder);
  if strcmp (method, 'ours')
    params = oursHandsBack (root, Case);
  else
    params = publishedMethod (Case, @() coreMinutes (folder) >= limit);
  end
  residual = NaN (1, 2);
  if ~isempty (params)
    Z = evaluateDEM (repmat (params, 5, 1), Case, (101:105)', 'confirm', ...
                     @(varargin) []);
    residual = mean (Z, 1) ./ [Case.targets.value] - 1;
  end
  exportRuns (fullfile (folder, 'all-runs.csv'), Case, gatherRuns (Case));
  [minutes, runs, failed] = coreMinutes (folder);
  confirmed = all (abs (residual) <= 0.01);
  dlmwrite ('attempt.csv', [runs, failed, minutes, residual, confirmed], ...
            'precision', '%.8g');
end

% What a user does: the main script, in a process of its own.
function params = oursHandsBack (root, Case)
  system (sprintf ('octave-cli --no-history "%s"', ...
                   fullfile (root, 'DEcalioc.m')));
  result = jsondecode (fileread (fullfile (Case.folder, 'results', ...
                                           'calibration.json')));
  params = cellfun (@(name) result.params.(name), Case.names);
end

function [minutes, runs, failed] = coreMinutes (folder)
  names = listRunFolders (folder, 'Lift100');
  seconds = zeros (1, numel (names));
  isOk = false (1, numel (names));
  for i = 1:numel (names)
    run = fullfile (folder, 'optim', 'Lift100', names{i});
    if isfile (fullfile (run, 'cpu.txt'))
      seconds(i) = str2double (fileread (fullfile (run, 'cpu.txt')));
    end
    record = readRecord (fullfile (run, 'record.json'));
    isOk(i) = ~isempty (record) && strcmp (record.status, 'ok');
  end
  minutes = sum (seconds(isfinite (seconds))) / 60;
  runs = numel (names);
  failed = sum (~isOk);
end

args = argv ();
root = fileparts (fileparts (mfilename ('fullpath')));
addpath (fullfile (root, 'infrastructure'), fullfile (root, 'benchmarks'));
attempt (root, args{1}, str2double (args{2}));
