% MWEATTEMPT  One attempt of the benchmark mwe, in the folder of its case.
%
% CALL: octave-cli mweAttempt.m METHOD LEDGER KEY LIMIT
% in the folder of mweCase
%
% METHOD  'ours' or 'published'
% LEDGER  text, the file of all runs, see mweLedger
% KEY     scale,repetition,method,attempt: the attempt's name in the ledger
% LIMIT   core minutes that the published tool may spend before it confirms
%
% Calibrates, runs the set that is handed back with 5 further packings, and
% writes attempt.csv: runs, failed runs, core minutes, mean residual of each
% target, confirmed (1 or 0). Without a set the residuals are NaN. Every run
% goes into the ledger.
%
% See also: mwe, mweCase, mweLedger, publishedMethod

1;

function attempt (root, method, ledger, limit)
  folder = pwd ();
  startToolbox (root, folder);
  Case = loadCase (root, folder);
  ledger.limit = limit;
  if strcmp (method, 'ours')
    params = oursHandsBack (root, Case);
    noteStore (Case, ledger);
  else
    params = publishedMethod (Case, @(P) evaluated (P, 1, 'published', ...
                                                    Case, ledger));
    Case.modelVars.ownSeed = 0;
  end
  residual = NaN (1, 2);
  if ~isempty (params)
    ledger.limit = Inf;
    Z = evaluated (repmat (params, 5, 1), 101:105, 'confirm', Case, ledger);
    residual = mean (Z, 1) ./ [Case.targets.value] - 1;
  end
  runs = mweLedger (ledger.file, ledger.key);
  dlmwrite ('attempt.csv', ...
            [rows(runs), sum(any (isnan (runs), 2)), sum(runs(:, end)) / 60, ...
             residual, all(abs (residual) <= 0.01)], 'precision', '%.8g');
end

% What a user does: the main script, in a process of its own.
function params = oursHandsBack (root, Case)
  system (sprintf ('octave-cli --no-history "%s"', ...
                   fullfile (root, 'DEcalioc.m')));
  result = jsondecode (fileread (fullfile (Case.folder, 'results', ...
                                           'calibration.json')));
  params = cellfun (@(name) result.params.(name), Case.names);
end

% Results from the ledger, or from a run that then goes into it.
function Z = evaluated (P, replicate, stage, Case, ledger)
  replicate = replicate(:) .* ones (rows (P), 1);
  batch = Case.options.maxCPU;
  for first = 1:batch:rows (P)
    at = first:min (first + batch - 1, rows (P));
    at = at(~isNoted ([replicate(at), P(at, :)], Case, ledger));
    if isempty (at)
      continue
    end
    minutes = sum (mweLedger (ledger.file, ledger.key)(:, end)) / 60;
    if minutes >= ledger.limit
      error ('DEcalioc:mweAttempt:spent', ...
             'mweAttempt: %.1f core minutes are spent', minutes);
    end
    [z, records] = evaluateDEM (P(at, :), Case, replicate(at), stage, ...
                                @(varargin) []);
    for i = 1:numel (at)
      note (records(i), z(i, :), ledger);
    end
  end
  runs = mweLedger (ledger.file, ledger.key);
  [~, k] = isNoted ([replicate, P], Case, ledger);
  Z = runs(k, end - numel (Case.targets):end - 1);
end

% Another machine differs in the last digits, and an optimum in some more; the
% differences of the published tool are a thousand times as large.
function [is, at] = isNoted (inputs, Case, ledger)
  runs = mweLedger (ledger.file, ledger.key);
  at = zeros (rows (inputs), 1);
  scale = [1, diff(Case.limits)];
  for i = 1:rows (inputs)
    for j = rows (runs):-1:1
      apart = (runs(j, 1:columns (inputs)) - inputs(i, :)) ./ scale;
      if max (abs (apart)) < 1e-6
        at(i) = j;
      end
    end
  end
  is = at > 0;
end

function noteStore (Case, ledger)
  T = numel (Case.targets);
  names = listRunFolders (Case.folder, 'Lift100');
  for i = 1:numel (names)
    record = readRecord (fullfile (Case.folder, 'optim', 'Lift100', ...
                                   names{i}, 'record.json'));
    if isempty (record) || isNoted ([record.replicate, record.params(:)'], ...
                                    Case, ledger)
      continue
    end
    z = NaN (1, T);
    if strcmp (record.status, 'ok')
      z = record.results(1:T)(:)';
    end
    record.folder = fullfile (Case.folder, 'optim', 'Lift100', names{i});
    note (record, z, ledger);
  end
end

function note (record, z, ledger)
  seconds = str2double (fileread (fullfile (record.folder, 'cpu.txt')));
  mweLedger (ledger.file, ledger.key, ...
             [record.replicate, record.params(:)', z, seconds]);
end

args = argv ();
addpath (fileparts (fileparts (mfilename ('fullpath'))));
attempt (startBenchmarks (), args{1}, ...
         struct ('file', args{2}, 'key', args{3}), str2double (args{4}));
