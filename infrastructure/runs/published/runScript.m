% RUNSCRIPT  One DEM run: folder, data.head, params.csv, simulation, results.
%
% CALL: RESULTS = runScript (MATR, MODEL)
%       [RESULTS, RECORD] = runScript (MATR, MODEL, CASE, JOB)
%
%   MATR     1 x (d + 2): parameters, row number of the plan (0: none), model
%            number
%   MODEL    name of the model (text)
%   CASE     see newCase (default: the case of the current folder)
%   JOB      see newJobs (default: first replicate without effects)
%   RESULTS  cell of scalars, NaN where a result is missing
%   RECORD   run record, see newRecord
%
% The simulation is waited for. A run that is in the store is not run again.
%
% See also: Start, startSimulation, prepareRun, judgeRun, evaluateRun

function [results, record] = runScript (matr, model, Case, job)
  if nargin < 3
    Case = loadCase ();
  end
  Case.hashes = hashModels (Case);
  if nargin < 4
    jobs = newJobs (Case, matr(1:end - 2), [], 1, 'plan');
    job = jobs(strcmp ({jobs.model}, model));
    job.planRow = matr(end - 1);
  end
  record = findRuns (job, Case){1};
  while strcmp (givenField (record, 'status', ''), 'forgotten')
    job = nextPacking (job, Case);
    record = findRuns (job, Case){1};
  end
  if ~strcmp (givenField (record, 'status', ''), 'ok')
    folder = prepareRun (job, Case);
    [~, name] = fileparts (folder);
    startSimulation (model, name, fileparts (runPlace (Case)));
    [record, place] = judgeRun (job, folder, Case);
    place.limit = Inf;         % this may be the user's own Octave
    record = evaluateRun (record, place);
  end
  nTargets = Case.models(strcmp (model, {Case.models.name})).nTargets;
  results = num2cell (NaN (1, nTargets));
  if strcmp (record.status, 'ok')
    results = num2cell (record.results);
  end
end

%!test
%! Case = readyCase ();
%! [res, record] = runScript ([1, 2, 3, 1], 'First', Case);
%! assert (res, {3, 2}, 1e-12);
%! assert (record.planRow, 3);
%! [~, again] = runScript ([1, 2, 3, 1], 'First', Case);
%! assert (again.folder, record.folder);

% SPDX-License-Identifier: GPL-3.0-only
