% UNEVALUATEDJOB  Job of a simulation that has ended but has no record.
%
% CALL: JOB = unevaluatedJob (FOLDER)
%
%   FOLDER  folder of a run whose record.json is missing or torn
%   JOB     see newJobs; [] where the simulation did not come to its end

function job = unevaluatedJob (folder)
  job = readRecord (fullfile (folder, 'job.json'));
  mark = readEndMark (folder);
  if isempty (mark) || ~strcmp (mark.reason, 'finished')
    job = [];
  end
end

%!test
%! Case = newCase (standInCase (tempname ()));
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(2);
%! folder = prepareRun (job, Case);
%! assert (isempty (unevaluatedJob (folder)));
%! writeAtomic (fullfile (folder, 'end.mark'), "143 1.0 killed\n");
%! assert (isempty (unevaluatedJob (folder)));
%! writeAtomic (fullfile (folder, 'end.mark'), "0 1.0 finished\n");
%! assert (unevaluatedJob (folder).key, job.key);
