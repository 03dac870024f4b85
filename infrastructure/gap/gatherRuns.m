% GATHERRUNS  Collects every finished run of a case that still counts.
%
% CALL: [DATA, COUNT] = gatherRuns (CASE)
%
%   CASE   see newCase
%   DATA   struct X (n x d), E (n x v), Z (n x T, NaN = none), replicate
%          (n x 1), stage (n x 1 cell)
%   COUNT  struct store (runs from the store), imported (rows of DATA from
%          runs.csv), ignored (cellstr, columns of runs.csv not understood)
%
% A run counts if it ended well and its key is what the models, the model
% variables and its own parameters give today. Rows of runs.csv that repeat a
% run of the store bit by bit are left out.
%
% See also: importRuns, runKey, diagnoseGap

function [data, count] = gatherRuns (Case)
  d = numel (Case.names);
  T = numel (Case.targets);
  v = numel (Case.effectVars);
  data = newData (d, T, v);
  count = struct ('store', 0, 'imported', 0, 'ignored', {{}});
  if all (cellfun (@(f) isfolder (f), {Case.models.folder}))
    [data, count.store] = fromStore (Case, data);
  end
  file = fullfile (Case.folder, 'runs.csv');
  if isfile (file)
    [table, count.ignored] = importRuns (file, Case);
    new = ~isKnown (table, data);
    count.imported = sum (new);
    data = addRows (data, table.X(new, :), table.Z(new, :), ...
                    table.replicate(new), 'import', table.E(new, :));
  end
end

function [data, n] = fromStore (Case, data)
  h = hashModels (Case);
  inputs = zeros (0, columns (data.X) + columns (data.E) + 1);
  Z = data.Z;
  stages = {};
  n = 0;
  for k = 1:numel (Case.models)
    own = [Case.targets.model] == k;
    names = listRunFolders (Case.store, Case.models(k).name);
    for i = 1:numel (names)
      record = readRecord (fullfile (Case.store, 'optim', ...
                                     Case.models(k).name, names{i}, ...
                                     'record.json'));
      effects = countsAs (record, Case, h(k), sum (own));
      if isempty (effects)
        continue
      end
      n = n + 1;
      row = [record.params(:)', effects{1}, record.replicate];
      at = find (all (inputs == row, 2), 1);
      if isempty (at)
        at = rows (inputs) + 1;
        inputs(at, :) = row;
        Z(at, :) = NaN (1, columns (Z));
        stages{at, 1} = record.stage;
      end
      index = [Case.targets(own).index];
      Z(at, own) = record.results(index);
    end
  end
  d = columns (data.X);
  data.X = inputs(:, 1:d);
  data.E = inputs(:, d + 1:end - 1);
  data.Z = Z;
  data.replicate = inputs(:, end);
  data.stage = stages;
end

% The effect values {1 x v} under which a record is a run of today's case; {} if
% it is none. A run of the plain model counts under any list of effects.
function effects = countsAs (record, Case, h, n)
  effects = {};
  if isempty (record) || ~isfield (record, 'status') || ...
     ~strcmp (record.status, 'ok') || numel (record.results) < n || ...
     numel (record.params) ~= numel (Case.names)
    return
  end
  trials = {neutralEffects(Case)};
  if numel (record.effects) == numel (trials{1})
    trials = [{reshape(record.effects, 1, [])}, trials];
  end
  for k = 1:numel (trials)
    job = record;
    job.effects = trials{k};
    key = runKey (runVariables (job, Case), Case.effectVars, h);
    if strcmp (key, record.key)
      effects = trials(k);
      return
    end
  end
end

function known = isKnown (imported, data)
  known = false (rows (imported.X), 1);
  stored = [data.X, data.E];
  for i = 1:rows (imported.X)
    same = find (all (stored == [imported.X(i, :), imported.E(i, :)], 2));
    for j = same'
      z = imported.Z(i, :);
      both = isfinite (z);
      known(i) = known(i) || isequal (z(both), data.Z(j, both));
    end
  end
end
