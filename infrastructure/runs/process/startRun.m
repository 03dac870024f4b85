% STARTRUN  Starts the simulation of a prepared run and does not wait for it.
%
% CALL: startRun (FOLDER, ROOT, OWNER)
%
%   FOLDER  folder of the run (text)
%   ROOT    folder of the toolbox (text)
%   OWNER   process number of the Octave that the run is for (default: this one)
%
% The run is watched by guard.sh, which ends it when OWNER is gone, and which
% writes end.mark.
%
% Errors: DEcalioc:startRun:runFailed
%
% See also: prepareRun, collectRuns, endRun

function startRun (folder, root, owner)
  if nargin < 3
    owner = getpid ();
  end
  guard = fullfile (root, 'infrastructure', 'runs', 'process', 'guard.sh');
  % setsid forks and comes back: the status of a command with & is always 0
  words = {shellQuote(guard), shellQuote(folder)};
  status = system (sprintf (['[ -r %s ] && [ -d %s ] && command -v bash > ' ...
                             '/dev/null && setsid --fork bash %s %s %d ' ...
                             '> /dev/null 2>&1 < /dev/null'], words{:}, ...
                            words{:}, owner));
  if status ~= 0
    error ('DEcalioc:startRun:runFailed', ...
           'startRun: the shell must start %s, it gave status %d.', ...
           guard, status);
  end
end

%!test
%! folder = emptyFolder ();
%! writeAtomic (fullfile (folder, 'runscript'), ...
%!              "sleep 0.5\necho $PPID > out\n");
%! root = fileparts (fileparts (which ('startToolbox')));
%! startRun (folder, root);
%! assert (isempty (readEndMark (folder)));
%! waitUntil (@() ~isempty (readEndMark (folder)));
%! assert (readEndMark (folder).reason, 'finished');
%! assert (load (fullfile (folder, 'out')), runPids (folder)(1));
%! % where the guard cannot note itself (a full disk), the run does not count
%! for file = {'pid', 'end.mark'}
%!   unlink (fullfile (folder, file{1}));
%! end
%! mkdir (fullfile (folder, 'pid'));
%! startRun (folder, root);
%! waitUntil (@() ~isempty (readEndMark (folder)));
%! assert (readEndMark (folder).reason, 'killed');
%! % what cannot start is said, not waited for
%! ids = {};
%! for places = {'/nowhere', folder; root, '/nowhere'}
%!   try
%!     startRun (places{:});
%!   catch err
%!     ids{end + 1} = err.identifier;
%!   end
%! end
%! assert (ids, repmat ({'DEcalioc:startRun:runFailed'}, 1, 2));

% SPDX-License-Identifier: GPL-3.0-only
