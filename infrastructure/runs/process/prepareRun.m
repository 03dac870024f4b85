% PREPARERUN  Makes the folder of a run, ready to be started.
%
% CALL: FOLDER = prepareRun (JOB, CASE)
%       prepareRun (JOB, CASE, FOLDER)     in a folder that is taken already
%
%   JOB     scalar struct, see newJobs; starts (optional): cell of run folders
%           that it starts from, of the same store (see stagesOf)
%   CASE    see newCase
%   FOLDER  path of the folder: the model's files, data.head with the run's
%           variables, params.csv, ExPlan.txt, cpu (which guard.sh hands to the
%           runscript as DECALIOC_CPU); job.json is written last, so a folder
%           without it is half-made and nobody's
%
% Errors: DEcalioc:prepareRun:missingField
%
% See also: startRun, takeRunFolder, copyModel

function folder = prepareRun (job, Case, folder)
  k = find (strcmp (job.model, {Case.models.name}));
  if nargin < 3
    folder = takeRunFolder (runPlace (Case, job.model));
  end
  copyModel (folder, Case.models(k).folder);
  head = fullfile (folder, 'data.head');
  writeAtomic (head, [fileread(head), "\n", ...
                      headLines(runVariables (job, Case))], false);
  stages = givenField (job, 'starts', {});
  names = stagesOf (Case.models(k).folder);
  if numel (stages) ~= numel (names)
    error ('DEcalioc:prepareRun:missingField', ...
           ['prepareRun: a run of %s starts from runs of %s, which evaluateDEM ' ...
            'and the calibration make, not runScript.'], job.model, ...
           strjoin (names, ', '));
  end
  for name = stages(:)'
    [place, number] = fileparts (name{1});
    [~, model] = fileparts (place);
    % of the same store, wherever that is moved to
    symlink (['../../', model, '/', number], fullfile (folder, model));
  end
  writeSet (folder, job.params, job.planRow);
  writeAtomic (fullfile (folder, 'cpu'), ...
               sprintf ("%d\n", Case.models(k).cpu), false);
  limit = max (Case.models(k).timeout, defaultLimit (Case.models(k)));
  if ~isnan (limit)
    writeAtomic (fullfile (folder, 'limit'), sprintf ("%d\n", ceil (limit)), ...
                 false);
  end
  job.owner = caseId (Case.folder);
  writeRecord (fullfile (folder, 'job.json'), job);
end

%!test
%! Case = readyCase ();
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(2);
%! folder = prepareRun (job, Case);
%! d = headDefaults (fullfile (folder, 'data.head'));
%! assert ([d.a, d.b, d.runSeed], [1, 2, job.seed]);
%! assert (readRecord (fullfile (folder, 'job.json')).key, job.key);
%! assert (! isequal (prepareRun (job, Case), folder));

% SPDX-License-Identifier: GPL-3.0-only
