% FOREIGNPLAN  Makes the runs that the diagnosis may learn from.
%
% CALL: DATA = foreignPlan (LAB, N0, NK)
%
%   LAB    struct with problem, run (see foreignLab)
%   N0     scalar, runs without any effect
%   NK     scalar, runs with each effect that DEM expresses, and it alone
%   DATA   struct X (n x p), E (n x v, values), Z (n x T), replicate (n x 1)
%
% Random lattices from the current random state; strengths from 0.1 to 1, of
% signed effects both ways in turn.
%
% See also: foreignLab

function data = foreignPlan (lab, n0, nk)
  limits = lab.problem.limits;
  p = columns (limits);
  dem = find (~[lab.problem.effects.laboratory]);
  K = numel (lab.problem.effects);
  theta = randomLattice (n0, p);
  phi = zeros (n0, K);
  for k = dem
    points = randomLattice (nk, p + 1);
    theta = [theta; points(:, 1:p)];
    extra = zeros (nk, K);
    extra(:, k) = strengths (points(:, p + 1), lab.isSigned(k));
    phi = [phi; extra];
  end
  data.X = limits(1, :) + theta .* diff (limits);
  data.E = foreignValues ([lab.problem.effects(dem).neutral], ...
                          [lab.problem.effects(dem).limits], phi(:, dem));
  data.Z = lab.run (theta, phi);
  data.replicate = ones (rows (theta), 1);
end

function phi = strengths (u, isSigned)
  phi = 0.1 + 0.9 * u;
  if isSigned
    phi(1:2:end) = -phi(1:2:end);
  end
end

%!test % sizes, neutral rows to the last digit, one effect a row
%! lab = foreignLab (1);
%! data = lab.plan (10, 4);
%! dem = ~[lab.problem.effects.laboratory];
%! neutral = [lab.problem.effects(dem).neutral];
%! assert (rows (data.X), 10 + 4 * sum (dem));
%! off = sum (data.E ~= neutral, 2);
%! assert (off(1:10), zeros (10, 1));
%! assert (off(11:end), ones (4 * sum (dem), 1));
%! assert (all (data.X >= lab.problem.limits(1, :)));
%! assert (all (data.X <= lab.problem.limits(2, :)));
%!test % same random state, same runs
%! lab = foreignLab (2);
%! for i = 1:2
%!   rand ('twister', 4);
%!   randn ('twister', 4);
%!   data{i} = lab.plan (5, 2);
%! end
%! assert (data{1}, data{2});

% SPDX-License-Identifier: GPL-3.0-only
