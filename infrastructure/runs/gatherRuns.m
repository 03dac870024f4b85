% GATHERRUNS  Collects every finished run of a case that still counts.
%
% CALL: [DATA, COUNT] = gatherRuns (CASE)
%       [DATA, COUNT] = gatherRuns (CASE, true)
%
%   CASE   see newCase; with true only runs that the case has made itself: of a
%          store that cases share, those of the others are evidence, too
%   DATA   struct X (n x d), E (n x v, as CASE.effectVars), Z (n x T, NaN = no
%          result, NA = not run), replicate (n x 1), stage (n x 1 cell)
%   COUNT  of runs at the last level, struct: stored (runs from the store),
%          noResult (runs of the store without one), imported (rows of DATA from
%          runs.csv), ignored (cellstr, columns of runs.csv not understood),
%          seconds (core time of one set of all models so far; NaN: not known)
%
% A run counts if it ended well and its key is what the models, the model
% variables and its own parameters give today. After a change in OctaveFuns it
% is evaluated again. One that ended well but gave a result that is not finite
% has NaN for all results of its model, as evaluateDEM does it, unless another
% packing of the same set gave some: that a slot jams is evidence, too. Failed
% runs tell nothing and are left out. So are runs that only verified a cure, see
% diagnoseMatrices, and rows of runs.csv that repeat a run of the store bit by
% bit.

function [data, count] = gatherRuns (Case, isOwn)
  which = {'model'};
  if nargin > 1 && isOwn
    which = {};
  end
  d = numel (Case.names);
  T = numel (Case.targets);
  v = numel (Case.effectVars);
  data = newData (d, T, v);
  count = struct ('stored', 0, 'noResult', 0, 'imported', 0, ...
                  'ignored', {{}}, 'seconds', NaN);
  if all (cellfun (@(f) isfolder (f), {Case.models.folder}))
    [data, count] = fromStore (Case, data, count, which);
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

function [data, count] = fromStore (Case, data, count, which)
  Case.hashes = hashModels (Case);
  inputs = zeros (0, columns (data.X) + columns (data.E) + 1);
  Z = data.Z;
  stages = {};
  seconds = NaN (1, numel (Case.models));
  for k = 1:numel (Case.models)
    ofModel = [Case.targets.model] == k;
    names = runFoldersOf (Case, Case.models(k).name, which{:});
    [records, effects] = runsOf (names, Case, k, Case.hashes(k));
    % coarse runs say nothing of what a set costs
    isLast = cellfun (@(e) atLastLevel (e, Case), effects);
    spent = cellfun (@(r) r.seconds, records(isLast));
    spent = spent(isfinite (spent));
    seconds(k) = sum (spent) / numel (spent) * Case.models(k).cpu;
    for i = 1:numel (records)
      record = records{i};
      % as runs are made: with 15 digits
      row = [toDigits([record.params(:)', effects{i}]), record.replicate];
      at = find (all (inputs == row, 2), 1);
      if isempty (at)
        at = rows (inputs) + 1;
        inputs(at, :) = row;
        % NA: not run; NaN: run without a result, which is evidence
        Z(at, :) = NA (1, columns (Z));
        stages{at, 1} = record.stage;
      end
      if strcmp (record.status, 'ok')
        count.stored = count.stored + isLast(i);
        Z(at, ofModel) = record.results([Case.targets(ofModel).index]);
      else
        count.noResult = count.noResult + isLast(i);
        missing = ofModel & isna (Z(at, :));
        Z(at, missing) = NaN;
      end
    end
  end
  count.seconds = seconds;
  d = columns (data.X);
  data.X = inputs(:, 1:d);
  data.E = inputs(:, d + 1:end - 1);
  data.Z = Z;
  data.replicate = inputs(:, end);
  data.stage = stages;
end

% Runs of model K that count, and the effect values (1 x v) of each. What was
% evaluated by another getResults, or not at all, is evaluated first.
function [records, effects] = runsOf (names, Case, k, h)
  records = cell (1, numel (names));
  effects = cell (1, numel (names));
  stale = false (1, numel (names));
  for i = 1:numel (names)
    folder = runPlace (Case, Case.models(k).name, names{i});
    records{i} = endedRun (folder, h);
    effects{i} = countsToday (records{i}, folder, Case, h);
    stale(i) = ~isempty (effects{i}) && ~strcmp (records{i}.funs, h.funs);
  end
  if any (stale)
    jobs = [records{stale}];
    records(stale) = num2cell (collectRuns (jobs, {jobs.folder}, Case));
  end
  least = Case.models(k).nTargets;
  counts = ~cellfun (@isempty, effects);
  isWhole = @(r) numel (r.results) >= least && ...
                 (strcmp (r.status, 'ok') || ...
                  (strcmp (r.status, 'invalid') && ...
                   ~all (isfinite (r.results))));
  counts(counts) = cellfun (isWhole, records(counts));
  records = records(counts);
  effects = cellfun (@(e) e{1}, effects(counts), 'UniformOutput', false);
end

% Record of a run whose simulation has ended well, [] for all others.
function record = endedRun (folder, h)
  found = readRun (folder, h);
  record = [];
  if isempty (found) || strcmp (found.stage, 'cure') || ...
     ~any (strcmp (givenField (found, 'status', 'ended'), ...
                   {'ok', 'invalid', 'ended'}))
    return
  end
  record = setfield (newRecord (found, folder), 'status', 'ok');
  for name = intersect (fieldnames (record), fieldnames (found))'
    record.(name{1}) = found.(name{1});
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

%!test
%! % models that are there and a store that is empty: only runs.csv counts
%! raw = standInCase (tempname ());
%! Case = newCase (raw);
%! writeAtomic (fullfile (raw.folder, 'runs.csv'), ...
%!              ["model,a,b,First_1,First_2,Second_1\n", ...
%!               "First,2,3,7,1,\nFirst,4,5,8,2,\n"]);
%! [data, count] = gatherRuns (Case);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (raw.folder, 's');
%! assert (data.X, [2, 3; 4, 5]);
%! assert ([count.stored, count.imported], [0, 2]);
%! assert (isnan (count.seconds));

% SPDX-License-Identifier: GPL-3.0-only
