% ESTIMATENOISE  How the scatter of a run follows the response, by replicates.
%
% CALL: LAW = estimateNoise (X, Z)
%
% X, Z  n x d, n x T  parameter sets, responses (NaN: none)
% LAW   1 x T cell: handle, response -> variance of one run there; [] where 8 or
%       more degrees of freedom of replicates do not show that the scatter
%       follows the response: the slope of log sd on log |mean| over the groups
%       is positive by more than 2 of its standard deviations, which are larger
%       where the groups lie farther from the line than chi squared ones do: a
%       group with a wrong run tells of no law
%
% The law is c |response|^(2 slope), the slope limited to 2, with the c for
% which it gives the sum of squares that the groups have.

function law = estimateNoise (X, Z)
  [~, ~, group] = unique (X, 'rows');
  law = cell (1, columns (Z));
  for t = 1:columns (Z)
    ok = isfinite (Z(:, t));
    z = Z(ok, t);
    [~, ~, g] = unique (group(ok));
    n = accumarray (g, 1);
    m = accumarray (g, z) ./ n;
    ss = accumarray (g, (z - m(g)).^2);
    slope = slopeOf (m, ss, n);
    if slope > 0 && sum (n - 1) >= 8
      law{t} = varianceLaw (slope, abs (m), ss, n);
    end
  end
end

% Slope of log sd on log |mean|; 0 where it is not sure.
function slope = slopeOf (m, ss, n)
  slope = 0;
  use = n > 1 & ss > 0 & m ~= 0;
  if sum (use) < 4
    return
  end
  % mean and variance of log s, s^2 a mean of df squared normal numbers; at
  % df = 1 the usual 1 / (2 df) is less than half of the variance
  df = n(use) - 1;
  weight = 2 ./ sqrt (psi (1, df / 2));
  y = 0.5 * (log (ss(use)) - psi (df / 2) - log (2));
  A = [ones(sum (use), 1), log(abs (m(use)))];
  if std (A(:, 2)) >= 0.05
    b = (weight .* A) \ (weight .* y);
    S = inv (A' * (weight.^2 .* A));
    beyond = max (1, sumsq (weight .* (y - A * b)) / max (1, sum (use) - 2));
    slope = b(2) * (b(2) > 2 * sqrt (beyond * S(2, 2)));
  end
end

% Held at 1 % of the usual response: at a response of 0 the law would be 0.
function law = varianceLaw (slope, usual, ss, n)
  slope = min (slope, 2);
  least = 0.01 * median (usual);
  shape = @(y) max (abs (y), least).^(2 * slope);
  c = sum (ss) / sum ((n - 1) .* shape (usual));
  law = @(y) c * shape (y);
end

%!test
%! % proportional scatter is seen (30 groups of 4: chance below 1 %)
%! randn ('twister', 1);
%! X = kron ((1:30)', ones (4, 1));
%! law = estimateNoise (X, X .* (1 + 0.1 * randn (120, 1))){1};
%! assert (sqrt (law (20)), 2, 0.7);
%! assert (log2 (law (20) / law (10)) / 2, 1, 0.4);

%!test
%! % replicates at small responses, single runs at large ones: the law holds
%! % the scatter where it was seen (chance of failing below 1 %); not every
%! % response has such runs
%! randn ('twister', 3);
%! X = [kron(linspace (1, 3, 10)', ones (5, 1)); (10:40)'];
%! Z = X .* (1 + 0.1 * randn (81, 1));
%! law = estimateNoise (X, [Z, setfield(Z, {1:50}, NaN)]);
%! assert (sqrt (law{1}(2)), 0.2, 0.06);
%! assert (isempty (law{2}));

%!test
%! % constant scatter is called constant (2 % are not: above 15 of 200 by chance
%! % in less than 0.1 %)
%! randn ('twister', 4);
%! X = kron ((1:8)', [1; 1]);
%! called = 0;
%! for k = 1:200
%!   law = estimateNoise (X, 5 + X + 0.1 * randn (16, 1));
%!   called = called + ~isempty (law{1});
%! end
%! assert (called <= 15);

% SPDX-License-Identifier: GPL-3.0-only
