% CORRELATESERIES  Estimates how alike measurement errors along a series are.
%
% CALL: [PROBLEM, LENGTHS] = correlateSeries (PROBLEM, EM, OPTIONS)
%
%   PROBLEM  struct of newGapProblem; estimateSeries (1 x T) marks the targets
%   EM, OPTIONS   of fitEmulator, gapOptions
%   PROBLEM  the same with covariance;  LENGTHS  1 x T, 0: independent
%
% From what the calibrated model leaves of each series, less a quadratic in the
% coordinate: a gap is mostly smoother than that, the errors are not.
%
% See also: estimateCorrelation, measurementCovariance

function [problem, lengths] = correlateSeries (problem, em, options)
  lengths = zeros (size (problem.y));
  at = problem.used(problem.estimateSeries(problem.used));
  if isempty (at)
    return
  end
  models = makeHypotheses (problem, withoutEffects (em), options);
  fits = fitLibrary (models, problem.y(problem.used));
  residual = NaN (size (problem.y));
  M = predictGap (em, [], fits.calibrated.Q);
  residual(problem.used) = problem.y(problem.used) - M(problem.used);
  for s = unique (problem.series(at))
    own = at(problem.series(at) == s);
    x = problem.coordinate(own);
    r = residual(own) - polyval (polyfit (x, residual(own), ...
                                          min (2, numel (own) - 2)), x);
    L = estimateCorrelation (r, problem.sd(own), x);
    lengths(problem.series == s & problem.estimateSeries) = L;
  end
  known = problem.covariance;
  problem.covariance = measurementCovariance (problem.sd, problem.series, ...
                                              problem.coordinate, lengths);
  if ~isempty (known)
    free = lengths' == 0 & lengths == 0;
    problem.covariance(free) = known(free);
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
%! given = struct ('y', y, 'sd', 0.1 * ones (1, 60), 'limits', [0; 1], ...
%!                 'bench', kron ([1, 2], ones (1, 30)));
%! given.series = given.bench;
%! given.coordinate = [x, x];
%! given.estimateSeries = true (1, 60);
%! problem = newGapProblem (given);
%! options = gapOptions (struct ('trend', 'affine'));
%! em = fitEmulator (problem, data, options);
%! [problem, lengths] = correlateSeries (problem, em, options);
%! assert (lengths(1) > 0.04 && lengths(1) < 0.5);
%! assert (lengths(31), 0);
%! assert (problem.covariance(1, 2) > 0.004);
%! assert (problem.covariance(31, 32), 0);
