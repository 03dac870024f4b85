% ISOWNRUN  Tells whether a run belongs to a case: nobody else may end it.
%
% CALL: YES = isOwnRun (JOB, CASE)
%
%   JOB   job or record of the run, see newJobs
%         may also be a kind of readLibrary
%   CASE  see newCase; where Input.store is the case folder all runs are its
%         own, else those with its id (caseId). A job of a case without an
%         id names the folder alone, or nothing, and is nobody's then
%   YES   logical

function yes = isOwnRun (job, Case)
  owner = givenField (job, 'owner', '');
  yes = ~sharesStore (Case) || ...
        (isempty (owner) && ...
         strcmp (givenField (job, 'origin', ''), Case.folder)) || ...
        (~isempty (owner) && strcmp (owner, caseId (Case.folder)));
end

%!test
%! Case = struct ('store', '/s', 'folder', '/a');
%! assert (isOwnRun (struct ('origin', '/a'), Case));
%! assert (! isOwnRun (struct ('origin', '/b'), Case));
%! assert (! isOwnRun (struct ('key', 'x'), Case));
%! Case.store = '/a';
%! assert (isOwnRun (struct ('key', 'x'), Case));
%! % two cases that were at one folder
%! folder = emptyFolder ();
%! Case = struct ('store', '/s', 'folder', folder);
%! job = struct ('origin', folder, 'owner', caseId (folder, true));
%! assert (isOwnRun (job, Case));
%! assert (! isOwnRun (setfield (job, 'owner', fliplr (job.owner)), Case));

% SPDX-License-Identifier: GPL-3.0-only
