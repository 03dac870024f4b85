% JUMPSPAST  Targets that lie in a jump of a response.
%
% CALL: [JUMP, NAMES] = jumpsPast (STATE, PROBLEM)
%
% STATE    struct of newState;  PROBLEM  see newProblem
% NAMES    cellstr of calibrated targets: two runs whose sets are within 5 % of
%          the box lie on both sides of the target, out of tolerance, and apart
%          by more than 30 % of the range of the response; not where runs of one
%          set do so, too, or scatter by a quarter of it: that is scatter
% JUMP     struct of the widest: from, to (results), names of the parameters
%          and their values on both sides as texts (where, beyond); empty texts
%          where there is none

function [jump, names] = jumpsPast (state, problem)
  data = runsThatCount (state.data, problem);
  U = toUnit (data.X, problem.limits);
  jump = struct ('from', NaN, 'to', NaN, 'where', '', 'beyond', '');
  isJump = false (size (problem.calibrate));
  widest = 0;
  for t = find (problem.calibrate)
    z = data.Z(:, t);
    half = problem.tol(t) * abs (problem.scale(t));
    low = find (z < problem.value(t) - half);
    high = find (z > problem.value(t) + half);
    [i, j, gap] = nearest (U, low, high);
    step = abs (z(j) - z(i)) / (max (z) - min (z));
    isJump(t) = gap > 0 && gap <= 0.05 && step > 0.3 && ...
                abs (z(j) - z(i)) > 4 * scatterOfSets (data.X, z);
    if isJump(t) && step > widest
      widest = step;
      jump = struct ('from', z(i), 'to', z(j), ...
                     'where', namedValues (problem.names, data.X(i, :)), ...
                     'beyond', namedValues (problem.names, data.X(j, :)));
    end
  end
  names = problem.targetNames(isJump);
end

% Of the runs of one set, all sets together; 0 where no set has several.
function sd = scatterOfSets (X, z)
  [X, z] = deal (X(isfinite (z), :), z(isfinite (z)));
  [~, ~, set] = unique (X, 'rows');
  freedom = numel (z) - max ([set; 0]);
  sd = 0;
  if freedom > 0
    middle = accumarray (set, z, [], @mean);
    sd = sqrt (sumsq (z - middle(set)) / freedom);
  end
end

% Two runs, one of each list, that are nearest to each other; Inf: none.
function [i, j, gap] = nearest (U, low, high)
  [i, j, gap] = deal ([], [], Inf);
  for k = low'
    [distance, m] = min (max (abs (U(high, :) - U(k, :)), [], 2));
    if distance < gap
      [i, j, gap] = deal (k, high(m), distance);
    end
  end
end

%!test
%! [problem, state] = smallCalibration ();
%! [~, names] = jumpsPast (state, problem);
%! assert (isempty (names));
%! X = state.data.X;
%! near = [0.5, 1; 0.51, 1.01];
%! Z = [3 + X(:, 1), 1 + (X(:, 1) > 0.505)];
%! s.data = addRows (newData (2, 2), [X; near], [Z; 3.5, 1; 3.51, 2], ...
%!                   ones (14, 1), 'plan');
%! problem.value = [3.5, 1.5];
%! [jump, names] = jumpsPast (s, problem);
%! assert (names, {'y'});
%! assert ({jump.from, jump.to, jump.beyond}, {1, 2, 'a = 0.51, b = 1.01'});
%! % beside the target a jump does no harm; runs of one set scatter
%! problem.value(2) = 2;
%! [~, names] = jumpsPast (s, problem);
%! assert (isempty (names));
%! problem.value(2) = 1.5;
%! wide = addRows (s.data, [1; 1; 1; 1] * X(1, :), [1, 1.1; 1, 1.9; 1, 1.2; 1, 1.8], ...
%!                 (2:5)', 'plan');
%! [~, names] = jumpsPast (setfield (s, 'data', wide), problem);
%! assert (isempty (names));
%! s.data = addRows (s.data, near(1, :), [3.5, 2], 2, 'plan');
%! [~, names] = jumpsPast (s, problem);
%! assert (isempty (names));

% SPDX-License-Identifier: GPL-3.0-only
