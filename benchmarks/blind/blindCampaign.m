% BLINDCAMPAIGN  Runs the campaign that all sealed cases share.
%
% CALL: blindCampaign (ROOT, WORK)
%
%   ROOT  folder of the toolbox
%   WORK  folder that keeps the runs; finished ones in it are used again
%
% On the benches of examples/hiddenEffect: 15 sets without effect, 12 of each of
% seven effects that its storedRuns.csv has four of, four of each of three
% pairs. Writes benchmarks/blind/storedRuns.csv: the rows of that table and the
% new ones. About 30 minutes of one core.
%
% See also: blind, campaignPlan

function blindCampaign (root, work)
  folder = fullfile (root, 'examples', 'hiddenEffect');
  before = cd (folder);
  back = onCleanup (@() cd (before));
  clear ('-f', 'loadInput', 'loadEffects');
  Case = withEffects (loadCase (root, folder));
  Case.store = work;
  Case.options.seed = 7;                % not the plan of the stored runs
  [~, ~] = mkdir (work);
  lock = lockCase (work);
  useLiggghts (root);
  problem = newProblem (Case);
  plan = fewer (campaignPlan (Case, problem.effects, wanted ()));
  say = @(text) sayLine (text, fullfile (work, 'campaign.log'));
  jobs = newJobs (Case, plan.X, plan.E, plan.replicate, 'gap');
  for from = 1:48:numel (jobs)
    i = from:min (from + 47, numel (jobs));
    text = sprintf ('runs %d to %d of %d', i([1, end]), numel (jobs));
    records(i) = runJobs (jobs(i), Case, newProgress (text, say));
    Case.models = addSeconds (Case.models, records(i));
  end
  records = reshape (records, numel (Case.models), rows (plan.X)).';
  file = fullfile (root, 'benchmarks', 'blind', 'storedRuns.csv');
  exportRuns (file, Case, tableOfRecords (plan, records, Case));
  lines = strsplit (strtrim (fileread (file)), "\n");
  old = strtrim (fileread (fullfile (folder, 'storedRuns.csv')));
  writeAtomic (file, [strjoin([{old}, lines(2:end)], "\n"), "\n"]);
  printf ('%d lines in %s\n', numel (strfind (fileread (file), "\n")), file);
end

function count = wanted ()
  count = struct ('neutral', 15, 'twice', 0, 'each', 12, 'ofPair', 4);
  count.pairs = {{'cohesion', 'tilt'}, {'liquidBridge', 'shape'}, ...
                 {'sizeSpread', 'vibration'}};
end

% Three effects have 30 sets already.
function plan = fewer (plan)
  has = ismember (plan.label, mostRun ());
  plan = structfun (@(v) v(~has, :), plan, 'UniformOutput', false);
end

function names = mostRun ()
  root = fileparts (fileparts (fileparts (mfilename ('fullpath'))));
  [given, data] = storedCampaign ('hiddenEffect', root);
  phi = strengthOfValues (newProblem (given).effects, data.E);
  many = sum (abs (phi) > 1e-9, 1) >= 12;
  names = {given.effects(many).name};
end
