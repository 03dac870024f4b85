% FAILEDRECORD  Record of a run that gave no result; also written to disk.
%
% CALL: RECORD = failedRecord (JOB, FOLDER, STATUS, MESSAGE, CAUSE)
%
%   JOB      see newJobs
%   FOLDER   folder of the run (text)
%   STATUS   'failed', 'timeout' or 'invalid'
%   MESSAGE  what happened (text)
%   CAUSE    'killed' (from outside: the same run may succeed), 'exit'
%            (default), 'output' or 'time'
%   RECORD   see newRecord
%
% See also: collectRuns, runJobs

function record = failedRecord (job, folder, status, message, cause)
  if nargin < 5
    cause = 'exit';
  end
  record = newRecord (job, folder);
  record.status = status;
  record.message = message;
  record.cause = cause;
  keepRecord (record);
end

%!test
%! folder = emptyFolder ();
%! r = failedRecord (standInJob (), folder, 'timeout', 'too long', 'time');
%! back = readRecord (fullfile (folder, 'record.json'));
%! assert ({back.message, back.cause}, {r.message, 'time'});
%! assert (isempty (back.results));

% SPDX-License-Identifier: GPL-3.0-only
