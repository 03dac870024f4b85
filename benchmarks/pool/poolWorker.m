% POOLWORKER  One run of poolPlan, in a worker of parcellfun.
%
% CALL: N = poolWorker (K, PLACE)
%
%   K      number of a run, 0 = none (parcellfun does not report its first
%          result to CumFunc)
%   PLACE  folder of the book of poolPlan, and of the claims
%   N      1 where a run was done, 0 otherwise
%
% See also: poolPlan

function n = poolWorker (k, place)
  n = 0;
  if k == 0
    return
  end
  load (fullfile (place, 'book'), 'jobs', 'Case', 'book');
  claim = fullfile (place, sprintf ('%d', k));
  [~, ~] = mkdir (claim);
  if ~isfile (fullfile (claim, 'folder'))
    folder = prepareRun (jobs(k), Case);
    writeAtomic (fullfile (claim, 'folder'), folder);
    guard = fullfile (Case.root, 'infrastructure', 'runs', 'guard.sh');
    system (sprintf ('setsid --wait bash %s %s %d', shellQuote (guard), ...
                     shellQuote (folder), book.owner));
  end
  % a run whose worker has died goes on under its guard
  folder = fileread (fullfile (claim, 'folder'));
  while isempty (readEndMark (folder))
    pause (0.2);
  end
  collectRuns (jobs(k), {folder}, Case, false);
  n = 1;
end
