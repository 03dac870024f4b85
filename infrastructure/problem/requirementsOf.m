% REQUIREMENTSOF  What has to be met: single targets, and whole curves.
%
% CALL: [GROUPS, NAMES] = requirementsOf (PROBLEM)
%
%   PROBLEM  struct with calibrate (1 x T) and curve (1 x T: targets with one
%            number above 0 are points of one curve of measured.csv)
%   GROUPS   1 x G cell of rows of target numbers, calibrated ones only
%   NAMES    1 x G cell, name of the target or of the curve
%
% The errors along a curve are alike, and so are those of its surrogates: fifty
% points of it are one requirement, not fifty.

function [groups, names] = requirementsOf (problem)
  use = find (problem.calibrate);
  number = problem.curve(use);
  number(number == 0) = -use(number == 0);
  [~, first] = unique (number, 'stable');
  groups = arrayfun (@(n) use(number == n), number(sort (first)), ...
                     'UniformOutput', false);
  if nargout > 1
    first = cellfun (@(g) g(1), groups);
    names = problem.targetNames(first);
    isCurve = cellfun (@numel, groups) > 1;
    names(isCurve) = problem.seriesNames(first(isCurve));
  end
end

%!test
%! problem = struct ('calibrate', [true, true, false, true, true], ...
%!                   'curve', [0, 2, 2, 0, 2]);
%! problem.targetNames = {'a', 'w@1', 'w@2', 'b', 'w@3'};
%! problem.seriesNames = {'', 'w', 'w', '', 'w'};
%! [groups, names] = requirementsOf (problem);
%! assert (groups, {1, [2, 5], 4});
%! assert (names, {'a', 'w', 'b'});
