% TRYMODELS  Makes one run of each model: the first set of the plan.
%
% CALL: RECORDS = tryModels (CASE, SAY)
%
%   CASE     see newCase
%   SAY      function handle that takes one line of text
%   RECORDS  1 x M struct array, see newRecord
%
% The runs belong to the plan, so a calibration takes them from the store. Where
% the plan has no row (runs.csv has them all) the middle of the box is run.
%
% See also: sayCheck, runJobs

function records = tryModels (Case, say)
  f = foresee (Case, struct ('model', {}, 'job', {}, 'state', {}, ...
                             'seconds', {}));
  if isempty (f.plan)
    f.plan = mean (Case.limits, 1);
  end
  jobs = newJobs (Case, f.plan(1, :), [], 1, 'plan');
  records = runJobs (jobs, Case, newProgress ('trial', say));
end

%!test
%! Case = newCase (standInCase (tempname ()));
%! records = tryModels (Case, @(text) []);
%! assert ({records.status}, {'ok', 'ok'});
%! p = records(1).params;
%! assert (records(1).results, [p(1) + p(2), p(1) * p(2)], 1e-12);
%! % they are runs of the plan
%! f = foresee (Case, runsOfCase (Case));
%! assert (find (f.isDone), [1, 2]);
