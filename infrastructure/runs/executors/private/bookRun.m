% BOOKRUN  Books the record of a run in a local plan, and what it teaches.
%
% CALL: PLAN = bookRun (PLAN, K, RECORD, CASE, REPORT)
%
%   PLAN          see newPlan in executeLocal; with the record, how long those
%                 that wait will take, and the runs of each model at least
%   K, RECORD     number of the run, see newRecord
%   CASE, REPORT  see executeLocal

function plan = bookRun (plan, k, record, Case, report)
  plan.records(k) = record;
  plan.status(k) = 'd';
  isDone = plan.status == 'd';
  done = plan.records(isDone);
  isOn = plan.status == 'b' | plan.status == 'r';
  setLimits (done, plan.jobs(isOn), plan.folders(isOn), Case);
  plan.foreseen = foreseenOf (plan, isDone);
  plan.usual = shortestOf (done, plan.jobs);
  report (struct ('total', numel (isDone), 'done', sum (isDone), ...
                  'failed', sum (~strcmp ({done.status}, 'ok')), ...
                  'running', sum (isOn), 'seconds', toc (plan.start)));
end

% Runs under way get a limit once three runs of their model have ended, and a
% higher one where others have taken longer since.
function setLimits (done, jobs, folders, Case)
  for i = 1:numel (jobs)
    k = strcmp (jobs(i).model, {Case.models.name});
    limit = defaultLimit (Case.models(k), done);
    file = fullfile (folders{i}, 'limit');
    if limit > str2double (['0', strtrim(checkReadText (file))])
      writeAtomic (file, sprintf ("%d\n", ceil (limit)), false);
    end
  end
end

% Long runs that start last keep all others waiting. How long a run will take
% is foreseen from the finished ones: log (seconds) linear in the parameters.
function foreseen = foreseenOf (plan, isDone)
  foreseen = plan.foreseen;
  waiting = find (plan.status == 'q');
  if isempty (waiting) || sum (isDone) > 200   % enough is known
    return
  end
  names = {plan.jobs.model};
  for model = unique (names(waiting))
    isSame = isDone & strcmp (names, model{1}) & ...
             strcmp ({plan.records.status}, 'ok') & [plan.records.seconds] > 0;
    mine = waiting(strcmp (names(waiting), model{1}));
    if sum (isSame) >= 4
      basis = @(jobs) [ones(numel (jobs), 1), vertcat(jobs.params)];
      logs = log ([plan.records(isSame).seconds]');
      foreseen(mine) = basis (plan.jobs(mine)) * ...
                       (pinv (basis (plan.jobs(isSame))) * logs);
    end
  end
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

%!test
%! % the record, a limit after three runs, how long the others will take
%! names = repmat ({'A'}, 1, 6);
%! plan = struct ('jobs', struct ('model', names, 'params', ...
%!                                num2cell ([1, 2, 3, 4, 5, 6])), ...
%!                'status', 'rddrqq', 'foreseen', zeros (1, 6), ...
%!                'folders', {cell(1, 6)}, 'start', tic (), 'records', ...
%!                struct ('model', names, 'status', 'ok', 'effects', [], ...
%!                        'seconds', num2cell (10 * 2.^(1:6))));
%! plan.folders{1} = tempname ();
%! mkdir (plan.folders{1});
%! Case.models = struct ('name', 'A', 'timeout', NaN, 'seconds', [], ...
%!                       'coarse', []);
%! plan = bookRun (plan, 4, plan.records(4), Case, @(s) assert (s.done, 3));
%! assert (fileread (fullfile (plan.folders{1}, 'limit')), "1600\n");
%! assert (plan.foreseen, zeros (1, 6));
%! plan = bookRun (plan, 1, plan.records(1), Case, ...
%!                 @(s) assert ([s.total, s.done, s.failed, s.running], ...
%!                              [6, 4, 0, 0]));
%! assert (plan.status, 'ddddqq');
%! assert (plan.foreseen(5:6), log (10 * 2.^(5:6)), 1e-9);
%! assert (plan.usual, 20 * ones (1, 6));

% SPDX-License-Identifier: GPL-3.0-only
