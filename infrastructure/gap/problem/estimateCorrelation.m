% ESTIMATECORRELATION  Correlation length of errors along a series.
%
% CALL: [L, GAIN] = estimateCorrelation (RESIDUAL, SD, COORDINATE)
%
%   RESIDUAL    1 x n, measured less a smooth fit of one series; NaN: left out
%   SD          1 x n, standard uncertainties; only their ratios matter
%   COORDINATE  1 x n, place on the series
%   L           correlation length in the unit of COORDINATE; 0: independent
%   GAIN        log likelihood ratio of L against independent errors
%
% Maximum likelihood of residuals with covariance s^2 sd_i sd_j exp (-|at_i -
% at_j| / L), s profiled out, L on 60 steps of a logarithmic grid from a third
% of the least distance to the whole length of the series. L is 0 unless GAIN
% is above 1.92, which 1 to 2 of 100 series of independent errors reach.
% What the smooth fit has taken out of the errors is missing here: L is rather
% too short than too long.
%
% See also: measurementCovariance

function [L, gain] = estimateCorrelation (residual, sd, coordinate)
  L = 0;
  gain = 0;
  ok = isfinite (residual) & isfinite (coordinate) & sd > 0;
  z = residual(ok)(:) ./ sd(ok)(:);
  at = coordinate(ok)(:);
  steps = diff (unique (at));
  if numel (z) < 4 || isempty (steps) || ~any (z)
    return
  end
  grid_ = logspace (log10 (min (steps) / 3), log10 (max (at) - min (at)), 60);
  D = abs (at - at');
  fit = arrayfun (@(l) logLikelihood (z, exp (-D / l)), grid_);
  [best, i] = max (fit);
  gain = max (best - logLikelihood (z, eye (numel (z))), 0);
  if gain > 1.92
    L = grid_(i);
  end
end

function fit = logLikelihood (z, R)
  n = numel (z);
  R(1:n + 1:end) = 1 + 1e-6;
  root = chol (R, 'lower');
  w = root \ z;
  fit = -n / 2 * log (w' * w / n) - sum (log (diag (root)));
end

%!function r = draw (L, at, sd)
%!  root = chol (exp (-abs (at' - at) / L) + 1e-9 * eye (numel (at)));
%!  r = sd .* (randn (1, numel (at)) * root);
%!endfunction
%!test
%! % 60 points, length 4 steps: within a factor of two (seeded; a fresh seed
%! % fails in 8 of 100)
%! randn ('twister', 2);
%! at = 0.5 * (1:60);
%! sd = 1 + at / 10;
%! L = estimateCorrelation (draw (2, at, sd), sd, at);
%! assert (L > 1 && L < 4);
%!test
%! % independent errors, and too few to tell (2 seeds in 100 fail)
%! randn ('twister', 3);
%! at = 1:60;
%! r = randn (1, 60);
%! assert (estimateCorrelation (r, ones (1, 60), at), 0);
%! assert (estimateCorrelation (r(1:3), ones (1, 3), at(1:3)), 0);
%!test
%! % values at one place, gaps in the data, no residual at all
%! randn ('twister', 4);
%! at = kron (1:30, [1, 1]);
%! r = draw (5, at, ones (1, 60));
%! r(7) = NaN;
%! L = estimateCorrelation (r, ones (1, 60), at);
%! assert (L > 2 && L < 12);
%! assert (estimateCorrelation (zeros (1, 60), ones (1, 60), at), 0);
%! assert (estimateCorrelation (r, ones (1, 60), ones (1, 60)), 0);
