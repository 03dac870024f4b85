% ISOWNRUN  Tells whether a run belongs to a case: nobody else may end it.
%
% CALL: YES = isOwnRun (JOB, CASE)
%
%   JOB   job or record of the run, see newJobs
%   CASE  see newCase; where Input.store is the case folder all runs are its
%         own, else those that name it as their origin. A job of versions until
%         0.9.0 names none and is nobody's
%   YES   logical

function yes = isOwnRun (job, Case)
  yes = strcmp (Case.store, Case.folder) || ...
        strcmp (givenField (job, 'origin', ''), Case.folder);
end

%!test
%! Case = struct ('store', '/s', 'folder', '/a');
%! assert (isOwnRun (struct ('origin', '/a'), Case));
%! assert (! isOwnRun (struct ('origin', '/b'), Case));
%! assert (! isOwnRun (struct ('key', 'x'), Case));
%! Case.store = '/a';
%! assert (isOwnRun (struct ('key', 'x'), Case));
