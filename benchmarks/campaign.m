% CAMPAIGN  Runs the stored campaign of the benches Drum and SlotBin.
%
% CALL: octave-cli benchmarks/campaign.m WORK [SETS]
%
% WORK   folder that keeps the runs; finished ones in it are used again, so the
%        same command goes on where it stopped
% SETS   of each effect alone, 1 to 16 (default 12, as stored; more add to them)
%
% On two benches 45 sets without effect, six of them with a second packing,
% 12 for each of eight effects, 12 with two effects at once (campaignPlan). The
% case is benchmarks/drumAndBins. Writes its storedRuns.csv, with
% an empty result where a simulation ended without one (a slot that jams), and
% prints the tables of the case's README.
%
% About 75 minutes of one core.
%
% See also: campaignPlan, campaignTable, exportRuns

1;

function count = wanted (sets)
  count = struct ('neutral', 45, 'twice', 6, 'each', 16, 'ofPair', 4, ...
                  'first', sets);
  count.pairs = {{'cohesion', 'tilt'}, {'cohesion', 'opening'}, ...
                 {'meanSize', 'fill'}};
end

% The executor starts the longest runs first. In blocks of sets, a campaign that
% is stopped early has whole sets, in the order of the plan.
%
% Clumps are not run in the slot bins: those that have left are not deleted at
% the bottom of the box (LIGGGHTS 3.8, fix multisphere), pile up below the slots
% and block them. A run takes ten times as long then, for no result.
function records = runAll (plan, Case, say)
  jobs = newJobs (Case, plan.X, plan.E, plan.replicate, 'gap');
  isShape = repelem (strcmp (plan.label', 'shape'), numel (Case.models));
  left = isShape & strcmp ({jobs.model}, 'SlotBin');
  records = arrayfun (@(j) newRecord (j, ''), jobs);
  [records.cause] = deal ('not run');
  for from = 1:32:numel (jobs)
    i = from:min (from + 31, numel (jobs));
    text = sprintf ('runs %d to %d of %d', i([1, end]), numel (jobs));
    i = i(~left(i));
    records(i) = runJobs (jobs(i), Case, newProgress (text, say));
    Case.models = addSeconds (Case.models, records(i));
  end
  records = reshape (records, numel (Case.models), rows (plan.X)).';
end

% As exportRuns takes them; a run that ended may have all of its results, some or none.
function data = tableOfRecords (plan, records, Case)
  data = struct ('X', plan.X, 'E', plan.E, 'replicate', plan.replicate);
  data.Z = NaN (rows (plan.X), numel (Case.targets));
  data.ended = ismember (reshape ({records.status}, size (records)), ...
                         {'ok', 'invalid'});
  data.seed = reshape ([records.seed], size (records));
  for t = 1:numel (Case.targets)
    target = Case.targets(t);
    for i = find (data.ended(:, target.model))'
      results = records(i, target.model).results;
      if numel (results) >= target.index
        data.Z(i, t) = results(target.index);
      end
    end
  end
end

function sayCounts (plan, records, Case)
  seeds = arrayfun (@(i) runSeed (plan.X(i, :), plan.replicate(i), ...
                                  Case.options.seed), (1:rows (plan.X))');
  printf (['| sets | bench | runs | ok | of these at the second try | ' ...
           'no results | broken off |\n|---|---|---|---|---|---|---|\n']);
  for name = unique (plan.label, 'stable')'
    own = strcmp (plan.label, name{1});
    for k = 1:columns (records)
      made = own & ~strcmp ({records(:, k).cause}, 'not run')';
      ok = made & strcmp ({records(:, k).status}, 'ok')';
      empty = made & strcmp ({records(:, k).status}, 'invalid')';
      second = ok & [records(:, k).seed]' ~= seeds;
      printf ('| %s | %s | %d | %d | %d | %d | %d |\n', name{1}, ...
              Case.models(k).name, sum (made), sum (ok), sum (second), ...
              sum (empty), sum (made & ~ok & ~empty));
    end
  end
end

% Of all runs in the store, also those that were tried with another seed.
function sayCost (Case)
  total = 0;
  for k = 1:numel (Case.models)
    name = Case.models(k).name;
    seconds = [];
    for folder = listRunFolders (Case.store, name)(:)'
      record = readRecord (fullfile (Case.store, 'optim', name, folder{1}, ...
                                     'record.json'));
      if isfield (record, 'seconds')
        seconds(end + 1) = record.seconds;
      end
    end
    total = total + sum (seconds);
    printf ('%s: %d runs, median %.1f s, %.1f to %.1f s\n', name, ...
            numel (seconds), median (seconds), min (seconds), max (seconds));
  end
  printf ('%.0f core-minutes\n', total / 60);
end

history_save (false);
addpath (fileparts (mfilename ('fullpath')));
root = startBenchmarks ();
args = argv ();
if isempty (args)
  error ('DEcalioc:campaign:missingField', ...
         'campaign: a folder for the runs must be given: campaign.m WORK.');
end
sets = 12;
if numel (args) > 1
  sets = str2double (args{2});
end
work = make_absolute_filename (args{1});
[~, ~] = mkdir (work);
folder = fullfile (root, 'benchmarks', 'drumAndBins');
% Octave looks for loadInput.m in the working folder first
cd (folder);
Case = withEffects (loadCase (root, folder));
Case.store = work;
problem = newProblem (Case);
plan = campaignPlan (Case, problem.effects, wanted (sets));
say = @(text) sayLine (text, fullfile (work, 'campaign.log'));
lock = lockCase (work);
records = runAll (plan, Case, say);
data = tableOfRecords (plan, records, Case);
file = fullfile (root, 'benchmarks', 'drumAndBins', ...
                 'storedRuns.csv');
printf ('%d rows in %s\n', exportRuns (file, Case, data), file);
sayCounts (plan, records, Case);
sayCost (Case);
[~, ~, lines] = campaignTable (problem, data);
printf ('%s\n', lines{:});

% SPDX-License-Identifier: GPL-3.0-only
