% COLLECTRUNS  Makes run records of simulations that have ended.
%
% CALL: RECORDS = collectRuns (JOBS, FOLDERS, CASE, ALONE)
%
%   JOBS     1 x n struct array, see newJobs
%   FOLDERS  1 x n cell of run folders, each with an end mark
%   CASE     see newCase
%   ALONE    the worker that evaluated one of these has gone down already: each
%            by itself, and not at all where its time was up (default false)
%   RECORDS  1 x n struct array, see newRecord; also in the folders
%
% getResults is the user's: it runs in workers of parcellfun, which it may
% bring down without harm to the calibration.
%
% See also: judgeRun, evaluateRun

function records = collectRuns (jobs, folders, Case, alone)
  Case.hashes = hashModels (Case);
  [todo, places] = arrayfun (@(j, f) judgeRun (j, f{1}, Case), jobs, ...
                             folders, 'UniformOutput', false);
  records = [];
  if nargin < 4 || ~alone
    % of an earlier evaluation: it says nothing of this one
    [~] = cellfun (@(r) unlink (lateMark (r)), todo);
    try
      records = inWorkers (todo, places);
    catch
      % a worker is gone, and with it what all of them have done
    end
  end
  if isempty (records)
    records = cellfun (@evaluateAlone, todo, places, 'UniformOutput', false);
  end
  records = [records{:}];
end

function records = inWorkers (todo, places)
  records = parcellfun (min (numel (todo), nproc ()), @evaluateRun, todo, ...
                        places, 'UniformOutput', false, 'VerboseLevel', 0);
end

% After its worker has gone down: once more, unless its time was up.
function record = evaluateAlone (todo, place)
  reason = '';
  if ~isfile (lateMark (todo))
    try
      record = inWorkers ({todo}, {place}){1};
      return
    catch
      reason = ['getResults ended the Octave that ran it (or the record ' ...
                'could not be written)'];
    end
  end
  if isfile (lateMark (todo))
    reason = sprintf (['getResults had not ended after %g s, its limit ' ...
                       '(Input.timeout, or 20 times the simulation)'], ...
                      place.limit);
  end
  record = failedRecord (todo, todo.folder, 'invalid', reason, 'output');
end

function file = lateMark (record)
  file = fullfile (record.folder, 'getResults.late');
end

%!test
%! % a getResults that hangs is ended at the model's limit, the others count
%! Case = readyCase ();
%! funs = fullfile (Case.models(2).folder, 'OctaveFuns', 'getResults.m');
%! writeAtomic (funs, ["function res = getResults (model, name)\n", ...
%!                     "pause (100)\nres = {1};\nend\n"]);
%! Case.models(2).timeout = 2;
%! [Z, records] = evaluateDEM ([1, 2], Case);
%! assert (Z, [3, 2, NaN], 1e-12);
%! assert (records(2).status, 'invalid');
%! assert (~isempty (strfind (records(2).message, 'not ended after 2 s')));
%!test
%! % a worker that is killed in getResults: evaluated again, at once; the watch
%! % over its time limit once held the caller for all of it, then said it had
%! % been late
%! Case = readyCase ();
%! funs = fullfile (Case.models(2).folder, 'OctaveFuns', 'getResults.m');
%! writeAtomic (funs, ["function res = getResults (model, name)\n", ...
%!                     "global path\n", ...
%!                     "mark = [path, 'optim/', model, '/', name, ", ...
%!                     "'/seen'];\n", ...
%!                     "if ~isfile (mark)\n", ...
%!                     "  fclose (fopen (mark, 'w'));\n", ...
%!                     "  kill (getpid (), 9);\nend\nres = {7};\nend\n"]);
%! Case.models(2).timeout = 20;
%! [Z, records] = evaluateDEM ([1, 2], Case);
%! assert (Z, [3, 2, 7], 1e-12);
%! assert (records(2).status, 'ok');

% SPDX-License-Identifier: GPL-3.0-only
