% PLANEFFECTRUNS  Chooses where to run an effect so that its runs tell most.
%
% CALL: Q = planEffectRuns (N, HAVE, THETA, POSTERIOR, RANGE)
%
%   N          scalar, runs wanted
%   HAVE       m x (p + 1), runs that exist: parameters in [-1, 1] and strength
%   THETA      1 x p, fitted null model
%   POSTERIOR  struct Q (k x (p + 1)), weight (k x 1): where the effect would
%              have to be ([]: not known yet)
%   RANGE      1 x 2, range of the strength
%   Q          N x (p + 1)
%
% Without a posterior the first two runs stand at THETA with full and half
% strength (other sign where signed), the rest around it. Otherwise: posterior
% draws far from what exists (greedy maximin distance), so that runs made for
% any reason are counted.

function Q = planEffectRuns (n, have, theta, posterior, range)
  p = numel (theta);
  % the same points at each start: it asks for the runs that it has made
  u = integrationPoints (400, 2 * p + 2, 17).uniform;
  if isempty (posterior)
    near = max (min (theta + 0.8 * (u(:, p + 2:2 * p + 1) - 0.5), 1), -1);
    pool = [near, strengthOf(u(:, end), range)];
    fixed = [theta, range(2); theta, 0.5 * range(2)];
    if range(1) < 0
      fixed(2, end) = range(1);
    end
    fixed = fixed(rows (have) + 1:end, :);
  else
    at = lookUp (posterior.weight, u(1:200, end));
    pool = posterior.Q(at, 1:p + 1);
    fixed = zeros (0, p + 1);
  end
  Q = fixed(1:min (n, rows (fixed)), :);
  while rows (Q) < n
    taken = [have; Q];
    if isempty (taken)
      taken = [theta, 0];
    end
    distance = Inf (rows (pool), 1);
    for i = 1:rows (taken)
      % box and range count alike, whatever their units
      gap = (pool - taken(i, :)) ./ [2 * ones(1, p), diff(range)];
      distance = min (distance, sum (gap.^2, 2));
    end
    [~, best] = max (distance);
    Q(end + 1, :) = pool(best, :);
  end
end

function phi = strengthOf (u, range)
  % a weak effect tells little of itself
  phi = 0.15 + 0.85 * u;
  if range(1) < 0
    phi = 2 * u - 1;
    phi = sign (phi) .* max (abs (phi), 0.15);
  end
  phi = min (max (phi * range(2), range(1)), range(2));
end

function at = lookUp (weight, u)
  edges = cumsum (weight(:)) / sum (weight);
  at = zeros (numel (u), 1);
  for i = 1:numel (u)
    at(i) = find (edges >= u(i) - 1e-12, 1);
  end
end

%!test
%! Q = planEffectRuns (4, zeros (0, 3), [0.2, -0.4], [], [0, 1]);
%! assert (size (Q), [4, 3]);
%! assert (Q(1, :), [0.2, -0.4, 1]);
%! assert (all (Q(:, 3) > 0 & Q(:, 3) <= 1));
%!test
%! posterior = struct ('Q', [0.5, 0.5, 0.7], 'weight', 1);
%! Q = planEffectRuns (6, ones (1, 3), [0, 0], posterior, [-1, 1]);
%! assert (size (Q), [6, 3]);
%! assert (all (abs (Q(:)) <= 1));

% SPDX-License-Identifier: GPL-3.0-only
