% NEARROWS  Which rows of a library a case learns from.
%
% CALL: USE = nearRows (TABLE, PROBLEM)
%       USE = nearRows (TABLE, PROBLEM, BEYOND)
%
%   TABLE    see newData: runs of all cases on the bench
%   PROBLEM  see newProblem
%   BEYOND   part of the width ([]: 0.5)
%   USE      n x 1 logical: rows in the box, or beyond a limit by up to so much;
%            of more than 300 those of thinRuns
%
% What is gained by more: docs/benchmarks.md, The next material.

function use = nearRows (table, problem, beyond)
  if nargin < 3 || isempty (beyond)
    beyond = 0.5;
  end
  [~, use] = insideLimits (table.X, problem.limits, beyond);
  use(use) = thinRuns (keepRows (table, use), problem, 300);
end

%!test
%! table = addRows (newData (1, 1), (0:0.25:8)', (0:0.25:8)', ones (33, 1), ...
%!                  'library');
%! problem = struct ('limits', [2; 4], 'value', 3, 'sd', 0, 'calibrate', true);
%! assert (table.X(nearRows (table, problem)), (1:0.25:5)');
%! assert (table.X(nearRows (table, problem, 0)), (2:0.25:4)');

% SPDX-License-Identifier: GPL-3.0-only
