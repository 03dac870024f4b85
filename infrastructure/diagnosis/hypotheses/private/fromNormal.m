% FROMNORMAL  Maps standard normal numbers to the unknowns of a hypothesis.
%
% CALL: [Q, SLOPE] = fromNormal (UNKNOWNS, U)
%
%   UNKNOWNS  struct of viewHypothesis
%   U         n x d, coordinates in which every prior is N (0, 1)
%   Q         n x d, parameters in [-1, 1], strengths, size
%   SLOPE     n x d, dQ / dU
%
% Q = F^-1 (Phi (U)) with F the distribution function of the prior. In these
% coordinates no unknown has a limit and directions that the data leave open are
% exactly normal, so that fits need no projection and samples no rejection.

function [Q, slope] = fromNormal (unknowns, U)
  % farther out rounding makes Phi 0 or 1, and its inverse infinite
  U = min (max (U, -7), 7);
  density = exp (-0.5 * U.^2) / sqrt (2 * pi);
  below = 0.5 * erfc (-U / sqrt (2));
  width = unknowns.hi - unknowns.lo;
  Q = unknowns.lo + below .* width;
  slope = density .* width;
  cut = isfinite (unknowns.sd) & ~unknowns.isScale;
  if any (cut)
    lo = unknowns.pLo(cut);
    mass = unknowns.pHi(cut) - lo;
    % a normal cut to its limits, by its distribution function
    x = sqrt (2) * erfinv (2 * (lo + mass .* below(:, cut)) - 1);
    x = min (max (x, -8), 8);
    sd = unknowns.sd(cut);
    Q(:, cut) = min (max (unknowns.mean(cut) + sd .* x, unknowns.lo(cut)), ...
                     unknowns.hi(cut));
    % the ratio of both densities, from the chain rule
    slope(:, cut) = sd .* mass .* density(:, cut) .* ...
                    exp (0.5 * x.^2) * sqrt (2 * pi);
  end
  is = unknowns.isScale;
  if any (is)
    Q(:, is) = exp (unknowns.mean(is) + unknowns.sd(is) .* U(:, is));
    slope(:, is) = unknowns.sd(is) .* Q(:, is);
  end
end

%!shared unknowns
%! unknowns = struct ('lo', [-1, 0, -1, 0], 'hi', [1, 1, 1, Inf], ...
%!                    'mean', [0, 0, 0.4, log(2)], ...
%!                    'sd', [Inf, 0.5, 0.2, 0.7], ...
%!                    'isScale', [false, false, false, true]);
%! below = @(x) 1 - normalTail ((x - unknowns.mean) ./ unknowns.sd);
%! unknowns.pLo = below (unknowns.lo);
%! unknowns.pHi = below (unknowns.hi);
%!test
%! % medians, slopes against differences, limits never passed
%! Q = fromNormal (unknowns, zeros (1, 4));
%! assert (Q([1, 4]), [0, 2], 1e-12);
%! assert (Q(3), 0.4, 1e-3);
%! U = [0.3, -1, 1.5, 0.5];
%! [~, slope] = fromNormal (unknowns, U);
%! change = fromNormal (unknowns, U + 1e-6) - fromNormal (unknowns, U - 1e-6);
%! assert (slope, change / 2e-6, 1e-7);
%! far = fromNormal (unknowns, [9, 9, 9, 0; -9, -9, -9, 0]);
%! assert (all (all (far >= unknowns.lo & far <= unknowns.hi)));
%!test
%! % back again
%! U = [0.3, -1, 1.5, 0.5];
%! assert (toNormal (unknowns, fromNormal (unknowns, U)), U, 1e-9);

% SPDX-License-Identifier: GPL-3.0-only
