% REQUIREMENTSOF  What has to be met: single targets, and whole curves.
%
% CALL: [GROUPS, NAMES, ISJOINT] = requirementsOf (PROBLEM)
%       [GROUPS, NAMES, ISJOINT] = requirementsOf (PROBLEM, USE)
%
%   PROBLEM  struct with calibrate (1 x T) and curve (1 x T: targets with one
%            number above 0 are points of one curve of measured.csv); or the targets
%            of a case
%   USE      1 x n, numbers of targets (the calibrated ones)
%   GROUPS   1 x G cell of rows of target numbers, of USE only
%   NAMES    1 x G cell, name of the target, or of the curve of several points
%   ISJOINT  1 x G logical: judged together, the points of a curve, be it a single one
%
% The errors along a curve are alike, and so are those of its surrogates: fifty
% points of it are one requirement, not fifty.

function [groups, names, isJoint] = requirementsOf (problem, use)
  if ~isfield (problem, 'calibrate')
    problem = asProblem (problem);
  end
  if nargin < 2
    use = find (problem.calibrate);
  end
  number = problem.curve(use);
  number(number == 0) = -use(number == 0);
  [~, first] = unique (number, 'stable');
  groups = arrayfun (@(n) use(number == n), number(sort (first)), ...
                     'UniformOutput', false);
  first = cellfun (@(g) g(1), groups);
  isJoint = problem.curve(first) > 0;
  if isargout (2)
    names = problem.targetNames(first);
    isLong = cellfun (@numel, groups) > 1;
    names(isLong) = problem.seriesNames(first(isLong));
  end
end

% Of targets, of which a test says no more than it needs.
function problem = asProblem (targets)
  blank = struct ('name', '', 'role', 'calibrate', 'curve', 0, 'series', '');
  targets = arrayfun (@(t) mergeFields (blank, t), targets, 'UniformOutput', false);
  targets = [targets{:}];
  problem = struct ('calibrate', strcmp ({targets.role}, 'calibrate'), ...
                    'curve', double ([targets.curve]));
  problem.targetNames = {targets.name};
  problem.seriesNames = {targets.series};
end

%!test
%! problem = struct ('calibrate', [true, true, false, true, true], ...
%!                   'curve', [0, 2, 2, 0, 2]);
%! problem.targetNames = {'a', 'w@1', 'w@2', 'b', 'w@3'};
%! problem.seriesNames = {'', 'w', 'w', '', 'w'};
%! [groups, names] = requirementsOf (problem);
%! assert (groups, {1, [2, 5], 4});
%! assert (names, {'a', 'w', 'b'});
%! [groups, names, isJoint] = requirementsOf (problem, [1, 3]);
%! assert ({groups, names, isJoint}, {{1, 3}, {'a', 'w@2'}, [false, true]});

% SPDX-License-Identifier: GPL-3.0-only
