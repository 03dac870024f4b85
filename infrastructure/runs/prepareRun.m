% PREPARERUN  Makes the folder of a run, ready to be started.
%
% CALL: FOLDER = prepareRun (JOB, CASE)
%
%   JOB     scalar struct, see newJobs
%   CASE    see newCase
%   FOLDER  path of the folder: the model's files, data.head with the run's
%           variables, params.csv, ExPlan.txt, cpu (which guard.sh hands to the
%           runscript as DECALIOC_CPU); job.json is written last, so a folder
%           without it is half-made and nobody's
%
% See also: startRun, makeRunFolder

function folder = prepareRun (job, Case)
  k = find (strcmp (job.model, {Case.models.name}));
  place = fullfile (Case.store, 'optim', job.model);
  number = lastRunFolder (Case.store, job.model) + 1;
  folder = fullfile (place, runFolderName (number));
  while ~makeRunFolder (folder, Case.models(k).folder)
    number = number + 1;
    folder = fullfile (place, runFolderName (number));
  end
  appendVariables (folder, runVariables (job, Case));
  writeSet (folder, job.params, job.planRow);
  writeAtomic (fullfile (folder, 'cpu'), ...
               sprintf ("%d\n", Case.models(k).cpu), false);
  limit = Case.models(k).timeout;
  if isnan (limit)
    limit = defaultLimit (Case.models(k));
  end
  if ~isnan (limit)
    writeAtomic (fullfile (folder, 'limit'), sprintf ("%d\n", ceil (limit)), ...
                 false);
  end
  writeRecord (fullfile (folder, 'job.json'), job);
end

%!test
%! Case = newCase (standInCase (tempname ()));
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(2);
%! folder = prepareRun (job, Case);
%! d = headDefaults (fullfile (folder, 'data.head'));
%! assert ([d.a, d.b, d.runSeed], [1, 2, job.seed]);
%! assert (readRecord (fullfile (folder, 'job.json')).key, job.key);
%! assert (! isequal (prepareRun (job, Case), folder));
