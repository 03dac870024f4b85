% ENDRUNS  Ends simulations that are under way, and waits until they have ended.
%
% CALL: N = endRuns (FOLDERS, OTHERS, SINCE)
%
%   FOLDERS  1 x n cell of run folders
%   OTHERS   1 x m cell of run folders that their guards may have ended
%   SINCE    time from which on such an end counts
%   N        how many of FOLDERS have ended after 10 s, and of OTHERS since then
%
% See also: endRun

function n = endRuns (folders, others, since)
  cellfun (@endRun, folders, 'UniformOutput', false);
  left = false;
  for look = 1:50
    left = cellfun (@(f) nthargout (2, @runPids, f), folders);
    if ~any (left)
      break
    end
    pause (0.2);
  end
  n = numel (folders) - sum (left) + ...
      sum (cellfun (@(f) isKilledSince (f, since), others));
end

% By its guard, as its Octave was ended. Clocks of file systems lag by a bit, and
% stat gives whole seconds: a mark of the second in which this began counts.
function yes = isKilledSince (folder, start)
  mark = readEndMark (folder);
  yes = ~isempty (mark) && strcmp (mark.reason, 'killed') && ...
        stat (fullfile (folder, 'end.mark')).mtime >= floor (start - 0.1);
end

%!assert (endRuns ({}, {}, 0), 0)

% SPDX-License-Identifier: GPL-3.0-only
