% THINRUNS  Chooses runs of a large table that a fit can hold.
%
% CALL: [USE, TEXT] = thinRuns (TABLE, PROBLEM, MOST)
%
%   TABLE    struct X (n x d), E (n x v), Z (n x T), see importRuns
%   PROBLEM  value, statedSd and calibrate (1 x T) are read, see newProblem
%   MOST     runs that are kept at most
%   USE      n x 1 logical: all, or half of MOST those nearest to the targets,
%            in standard deviations, the other half spread over the box
%   TEXT     what is left out, for the user; '' where all are kept
%
% A Kriging model costs the square of its runs in memory and the cube in time.

function [use, text] = thinRuns (table, problem, most)
  n = rows (table.X);
  use = true (n, 1);
  text = '';
  if n <= most
    return
  end
  inputs = [table.X, table.E];
  width = max (inputs, [], 1) - min (inputs, [], 1);
  width = width + (width == 0);
  near = smoothed ((inputs - mean (inputs, 1)) ./ width, table.Z);
  use = nearest (near, problem, floor (most / 2));
  use = spread (inputs ./ width, use, most);
  text = sprintf (['%d of %d runs are used, the %d nearest to the targets ' ...
                   'and others spread over the box; %d are left out: a ' ...
                   'surrogate holds no more. What it says of places far ' ...
                   'from the targets is less sure than all runs would be'], ...
                  most, n, floor (most / 2), n - most);
end

% Responses without their scatter, by a square law through 5000 runs at most:
% chosen by what they scattered to, runs would all seem to give the targets.
function Z = smoothed (U, Z)
  [i, j] = find (triu (ones (columns (U))));
  H = [ones(rows (U), 1), U, U(:, i) .* U(:, j)];
  for t = 1:columns (Z)
    known = find (isfinite (Z(:, t)));
    if numel (known) > 3 * columns (H)
      few = known(unique (round (linspace (1, numel (known), 5000))));
      Z(known, t) = H(known, :) * (H(few, :) \ Z(few, t));
    end
  end
end

function use = nearest (Z, problem, most)
  sd = problem.statedSd;
  spread = std (Z(all (isfinite (Z), 2), :), 0, 1);
  bare = ~(isfinite (sd) & sd > 0);
  if isempty (spread)
    spread = ones (1, columns (Z));
  end
  sd(bare) = spread(bare) + (spread(bare) == 0);
  D = ((Z - problem.value) ./ sd).^2;
  D(:, ~problem.calibrate) = NaN;
  known = isfinite (D);
  D(~known) = 0;
  far = sum (D, 2) ./ sum (known, 2);
  far(isnan (far)) = Inf;
  [~, order] = sort (far);
  use = false (rows (Z), 1);
  use(order(1:most)) = true;
end

% One after the other the run that is farthest from all chosen ones; of very
% many every so many-th is looked at.
function use = spread (U, use, most)
  gap = Inf (rows (U), 1);
  if rows (U) > 20 * most + sum (use)
    part = unique ([round(linspace (1, rows (U), 20 * most)), find(use)']);
    use(part) = spread (U(part, :), use(part), most);
    return
  end
  for i = find (use)'
    gap = min (gap, sum ((U - U(i, :)).^2, 2));
  end
  for k = sum (use) + 1:most
    gap(use) = -1;
    [~, i] = max (gap);
    use(i) = true;
    gap = min (gap, sum ((U - U(i, :)).^2, 2));
  end
end

%!test
%! problem = struct ('value', [1, 2], 'statedSd', [0.1, 0.2], ...
%!                   'calibrate', [true, true]);
%! [a, b] = ndgrid (linspace (0, 1, 40));
%! table = struct ('X', [a(:), b(:)], 'E', zeros (1600, 0), ...
%!                 'Z', [2 * a(:), 4 * b(:)]);
%! [use, text] = thinRuns (table, problem, 100);
%! assert (sum (use), 100);
%! assert (~isempty (strfind (text, '100 of 1600 runs')));
%! % both halves do their part: the target at (0.5, 0.5), and all corners
%! near = max (abs (table.X(use, :) - 0.5), [], 2);
%! assert (sum (near < 0.15) >= 40);
%! corners = table.X(use, :) .* (1 - table.X(use, :));
%! assert (sum (all (corners == 0, 2)), 4);
%! [use, text] = thinRuns (table, problem, 1600);
%! assert (all (use) && isempty (text));
%!test
%! % 5 % scatter: the runs that are taken are off by as much either way
%! rand ('twister', 1);
%! randn ('twister', 1);
%! table = struct ('X', rand (8000, 1), 'E', zeros (8000, 0));
%! e = 0.05 * randn (8000, 1);
%! table.Z = 1 + table.X + e;
%! problem = struct ('value', 1.5, 'statedSd', 0.01, 'calibrate', true);
%! use = thinRuns (table, problem, 400);
%! near = use & abs (table.X - 0.5) < 0.05;
%! assert (sum (near) > 150 && std (e(near)) > 0.04);

% SPDX-License-Identifier: GPL-3.0-only
