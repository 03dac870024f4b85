% READSANE  Reads a job or a run record of a store that others can write to.
%
% CALL: RECORD = readSane (FILE)
%
%   FILE    path (text)
%   RECORD  see newRecord, newJobs; [] where there is none, or where it is torn
%           or says what no run says: what has a checksum need not be sane
%
% See also: readRecord, isRunRecord

function record = readSane (file)
  record = readRecord (file);
  if ~isRunRecord (record)
    record = [];
  end
end

%!test
%! Case = readyCase ();
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(1);
%! file = tempname ();
%! assert (isempty (readSane (file)));
%! writeRecord (file, job);
%! assert (readSane (file).key, job.key);
%! writeRecord (file, setfield (job, 'key', 'x'));
%! assert (isempty (readSane (file)));

% SPDX-License-Identifier: GPL-3.0-only
