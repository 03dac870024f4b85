% CURVELIKELIHOOD  Log likelihood of a measured curve at parameter sets.
%
% CALL: FIT = curveLikelihood (C, M, V, FREE)
%
% C     element of curveErrors
% M, V  n x p  mean and variance of the surrogates at the p points
% FREE  n x f  unknowns in [0, 1], C.free: the length over which the errors of
%       the measurement are alike (C.lengths, logarithmic), then their size (2 %
%       to twice the tolerance, logarithmic)
% FIT   n x 1  log density, normal
%
% Covariance: sd_i sd_j exp (-distance / length) of the measurement; of one
% packing, its standard deviations times C.rough; of the surrogates, sqrt (v_i
% v_j) times C.smooth. The last two are widened to the variance of a Student
% variable with C.df degrees of freedom. No Student density of the whole curve:
% its one unknown scale would be learned from the curve itself, which few runs
% fit well where the surrogates are wrong (benchmarks/curveFewRuns.m).

function fit = curveLikelihood (c, m, v, free)
  n = rows (m);
  fit = zeros (n, 1);
  R = correlation (c, c.length);
  S = (c.sd' * c.sd) .* R;
  packing = c.packingVar;
  if c.scatter
    % the scatter of the trials holds their packings
    packing = max (packing - c.sd.^2, 0);
  end
  df = max (c.df, 3);
  wider = df / (df - 2);
  packingSd = sqrt (wider * packing);
  fixed = (packingSd' * packingSd) .* c.rough;
  surrogateSd = sqrt (wider * v + eps (max (c.value.^2)));
  isFree = columns (free) > 0;
  for i = 1:n
    if isFree
      S = covariance (c, R, free(i, :));
    end
    sd = surrogateSd(i, :);
    root = chol (S + fixed + (sd' * sd) .* c.smooth);
    z = (c.value - m(i, :)) / root;
    fit(i) = -sum (log (diag (root))) - 0.5 * (z * z');
  end
end

% The unknowns: first the length, then the size, where they are not known.
function S = covariance (c, R, free)
  if isnan (c.length)
    R = correlation (c, c.lengths(1) * (c.lengths(2) / c.lengths(1))^free(1));
  end
  sd = c.sd;
  if ~c.sdKnown
    sd = c.half * 0.02 * 100^free(end);
  end
  S = (sd' * sd) .* R;
end

function R = correlation (c, length)
  R = full (eye (rows (c.distance)));
  if length > 0
    R = exp (-c.distance / length);
  end
  R(1:rows (R) + 1:end) = 1 + 1e-6;
end

%!shared c
%! c = struct ('points', 1, 'value', 2, 'sd', 3, 'distance', 0, 'rough', 1, ...
%!             'smooth', 1, 'packingVar', 4, 'scatter', false, 'length', 0, ...
%!             'lengths', [1, 9], 'sdKnown', true, 'half', 5, 'df', 7, ...
%!             'free', []);
%!test
%! % of one point: normal, what the runs tell widened by 7 / 5
%! f = @(v) -0.5 * log (v) - 0.5 * (2 - 0.5)^2 / v;
%! assert (curveLikelihood (c, 0.5, 3, zeros (1, 0)), f (18.8), 1e-5);
%! c.scatter = true;
%! assert (curveLikelihood (c, 0.5, 3, zeros (1, 0)), f (13.2), 1e-5);
%! % size unknown: half way between 0.1 and 10
%! c.scatter = false;
%! c.sdKnown = false;
%! assert (curveLikelihood (c, 0.5, 3, 0.5), f (10.8), 1e-5);
%!test
%! % two points that move together weigh as one
%! two = c;
%! two.sdKnown = true;
%! two.scatter = false;
%! [two.value, two.sd, two.packingVar] = deal ([2, 2], [3, 3], [0, 0]);
%! [two.distance, two.rough, two.smooth] = deal (zeros (2), eye (2), eye (2));
%! two.length = 1;
%! two.df = 1e6;
%! g = @(m) curveLikelihood (two, [m, m], [0, 0], zeros (1, 0));
%! assert (g (2) - g (5), 0.5, 1e-3);
%! two.length = 0;
%! g = @(m) curveLikelihood (two, [m, m], [0, 0], zeros (1, 0));
%! assert (g (2) - g (5), 1, 1e-3);
