% CORRELATESERIES  Estimates how alike measurement errors along a series are.
%
% CALL: [GAPPROBLEM, LENGTHS] = correlateSeries (GAPPROBLEM, EM, OPTIONS)
%
%   GAPPROBLEM   struct of newGapProblem; estimateSeries (1 x T) marks targets
%   EM, OPTIONS  of fitEmulator, gapOptions
%   GAPPROBLEM   the same with covariance;  LENGTHS  1 x T, 0: independent
%
% From what the calibrated model leaves of each series, less a quadratic in the
% coordinate: a gap is mostly smoother than that, the errors are not. Of less
% than four points nothing can be learned.
%
% See also: estimateCorrelation, measurementCovariance

function [gapProblem, lengths] = correlateSeries (gapProblem, em, options)
  lengths = zeros (size (gapProblem.value));
  at = gapProblem.used(gapProblem.estimateSeries(gapProblem.used));
  if isempty (at)
    return
  end
  residual = NaN (size (gapProblem.value));
  M = predictGap (em, [], calibrateNull (gapProblem, em, options));
  used = gapProblem.used;
  residual(used) = gapProblem.value(used) - M(used);
  for s = unique (gapProblem.series(at))
    own = at(gapProblem.series(at) == s);
    if numel (own) < 4
      continue
    end
    x = gapProblem.coordinate(own);
    u = (x - mean (x)) / max (std (x), realmin);
    degree = min (2, numel (unique (x)) - 1);
    r = residual(own) - polyval (polyfit (u, residual(own), degree), u);
    L = estimateCorrelation (r, gapProblem.sd(own), x);
    lengths(gapProblem.series == s & gapProblem.estimateSeries) = L;
  end
  known = gapProblem.covariance;
  gapProblem.covariance = ...
    measurementCovariance (gapProblem.sd, gapProblem.series, ...
                           gapProblem.coordinate, lengths);
  if ~isempty (known)
    free = lengths' == 0 & lengths == 0;
    gapProblem.covariance(free) = known(free);
  end
end

%!test
%! % errors alike over a third of the series are found, and only there (seeded)
%! rand ('twister', 7); randn ('twister', 7);
%! x = linspace (0, 1, 30);
%! data.X = rand (12, 1);
%! data.E = zeros (12, 0);
%! data.Z = data.X * [x, x] + 0.001 * randn (12, 60);
%! data.replicate = ones (12, 1);
%! C = exp (-abs (x' - x) / 0.15) + 1e-9 * eye (30);
%! y = 0.5 * [x, x] + 0.1 * [randn(1, 30) * chol(C), randn(1, 30)];
%! given = struct ('value', y, 'sd', 0.1 * ones (1, 60), 'limits', [0; 1], ...
%!                 'bench', kron ([1, 2], ones (1, 30)));
%! given.series = given.bench;
%! given.coordinate = [x, x];
%! given.estimateSeries = true (1, 60);
%! gapProblem = newGapProblem (given);
%! options = gapOptions (struct ('trend', 'affine'));
%! em = fitEmulator (gapProblem, data, options);
%! [gapProblem, lengths] = correlateSeries (gapProblem, em, options);
%! assert (lengths(1) > 0.04 && lengths(1) < 0.5);
%! assert (lengths(31), 0);
%! assert (gapProblem.covariance(1, 2) > 0.004);
%! assert (gapProblem.covariance(31, 32), 0);
%!test
%! % of a curve one point is measured, of the other one is calibrated to
%! x = linspace (0, 1, 6);
%! data.X = (1:8)' / 9;
%! data.E = zeros (8, 0);
%! data.Z = data.X * [x, x] + 1e-3 * sin (17 * (1:8)' * (1:12));
%! data.replicate = ones (8, 1);
%! given = struct ('value', 0.5 * [x, x], 'sd', 0.1 * ones (1, 12), ...
%!                 'limits', [0; 1], 'bench', kron ([1, 2], ones (1, 6)));
%! given.value([1, 3:6]) = NaN;
%! given.held = [false(1, 6), true, true, false, true, true, true];
%! given.series = given.bench;
%! given.coordinate = [x, x];
%! given.estimateSeries = true (1, 12);
%! gapProblem = newGapProblem (given);
%! options = gapOptions (struct ('trend', 'affine'));
%! em = fitEmulator (gapProblem, data, options);
%! [~, lengths] = correlateSeries (gapProblem, em, options);
%! assert (lengths, zeros (1, 12));
