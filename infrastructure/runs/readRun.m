% READRUN  Record of a run, or its job where it has ended but has no record.
%
% CALL: RUN = readRun (FOLDER)
%       RUN = readRun (FOLDER, H)
%
%   H       element of hashModels: the question of the case, see readingOf
%   RUN     see newRecord; without record.json, or where that is torn, the job
%           (see newJobs: no status) of a simulation that has come to its end;
%           else [], as where its folder was copied in part (no runscript). Its
%           field folder is FOLDER

function run = readRun (folder, h)
  run = readSane ([folder, '/record.json']);
  if ~isfield (run, 'status')
    run = [];
    % a copy that broke off has the mark, but not yet what comes later in the alphabet
    if strcmp (givenField (readEndMark (folder), 'reason', ''), 'finished') && ...
       isfile ([folder, '/runscript'])
      run = readSane ([folder, '/job.json']);
    end
  end
  if ~isempty (run)
    run.folder = folder;
    if nargin > 1
      run = readingOf (run, h);
    end
  end
end

%!test
%! Case = readyCase ();
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(2);
%! folder = prepareRun (job, Case);
%! assert (isempty (readRun (folder)));
%! writeAtomic (fullfile (folder, 'end.mark'), "143 1.0 killed\n");
%! assert (isempty (readRun (folder)));
%! writeAtomic (fullfile (folder, 'end.mark'), "0 1.0 finished\n");
%! run = readRun (folder);
%! assert ({run.key, run.folder, isfield(run, 'status')}, ...
%!         {job.key, folder, false});
%! script = fullfile (folder, 'runscript');
%! rename (script, [script, '.aside']);
%! assert (isempty (readRun (folder)));
%! rename ([script, '.aside'], script);
%! failedRecord (job, folder, 'invalid', 'x', 'output');
%! assert (readRun (folder).status, 'invalid');

% SPDX-License-Identifier: GPL-3.0-only
