% BOOKRUN  Books the record of a run in a local plan, and what it teaches.
%
% CALL: PLAN = bookRun (PLAN, K, RECORD, CASE, REPORT)
%
%   PLAN    see newPlan in executeLocal; with the record, the order of those
%           that wait, and how long the runs of each model take at least
%   K       number of the run
%   RECORD  see newRecord
%   CASE    see newCase
%   REPORT  function handle, called with the state

function plan = bookRun (plan, k, record, Case, report)
  plan.records(k) = record;
  plan.status(k) = 'd';
  isDone = plan.status == 'd';
  done = plan.records(isDone);
  isOn = plan.status == 'b' | plan.status == 'r';
  setLimits (done, plan.jobs(isOn), plan.folders(isOn), Case);
  plan.queue = longestFirst (plan.queue, plan.cpus, plan.jobs, ...
                             plan.records, isDone);
  plan.usual = shortestOf (done, plan.jobs);
  report (struct ('total', numel (isDone), 'done', sum (isDone), ...
                  'failed', sum (~strcmp ({done.status}, 'ok')), ...
                  'running', sum (isOn), 'seconds', toc (plan.start)));
end

% Runs under way get a limit once three runs of their model have ended well.
function setLimits (done, jobs, folders, Case)
  for i = 1:numel (jobs)
    k = strcmp (jobs(i).model, {Case.models.name});
    limit = defaultLimit (Case.models(k), done);
    file = fullfile (folders{i}, 'limit');
    if ~isnan (limit) && ~isfile (file)
      writeAtomic (file, sprintf ("%d\n", ceil (limit)), false);
    end
  end
end

% Long runs that start last keep all others waiting. How long a run will take
% is foreseen from the finished ones: log (seconds) linear in the parameters.
function queue = longestFirst (queue, cpus, jobs, records, isDone)
  enough = 200;
  if isempty (queue) || sum (isDone) > enough
    return
  end
  foreseen = zeros (1, numel (queue));
  for model = unique ({jobs(queue).model})
    isSame = isDone & strcmp ({jobs.model}, model{1}) & ...
             strcmp ({records.status}, 'ok') & [records.seconds] > 0;
    mine = find (strcmp ({jobs(queue).model}, model{1}));
    if sum (isSame) >= 4
      A = [ones(sum (isSame), 1), vertcat(jobs(isSame).params)];
      B = [ones(numel (mine), 1), vertcat(jobs(queue(mine)).params)];
      foreseen(mine) = B * (pinv (A) * log ([records(isSame).seconds])');
    end
  end
  [~, order] = sortrows ([-cpus(queue)', -foreseen', (1:numel (queue))']);
  queue = queue(order);
end

% Length of the shortest run so far of each job's model, NaN where none ended.
function seconds = shortestOf (done, jobs)
  seconds = NaN (1, numel (jobs));
  done = done(strcmp ({done.status}, 'ok'));
  for model = unique ({done.model})
    isOfModel = strcmp ({done.model}, model{1});
    seconds(strcmp ({jobs.model}, model{1})) = min ([done(isOfModel).seconds]);
  end
end
