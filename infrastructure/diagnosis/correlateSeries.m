% CORRELATESERIES  Estimates how alike measurement errors along a series are.
%
% CALL: [PROBLEM, LENGTHS] = correlateSeries (PROBLEM, EMULATOR, OPTIONS)
%
%   PROBLEM      struct of newProblem; estimateSeries (1 x T) marks targets
%   EMULATOR, OPTIONS  of fitEmulator, gapOptions
%   PROBLEM      the same with covariance;  LENGTHS  1 x T, 0: independent
%
% From what the calibrated model leaves of each series, less a quadratic in the
% coordinate: a gap is mostly smoother than that, the errors are not. Of less
% than four points nothing can be learned.
%
% Maximum likelihood of residuals with covariance s^2 sd_i sd_j exp (-|at_i -
% at_j| / L), s profiled out, L on 60 steps of a logarithmic grid from a third
% of the least distance to the whole length of the series. L is 0 unless the log
% likelihood gains 1.92, which 1 to 2 of 100 series of independent errors reach.
% What the quadratic has taken out of the errors is missing: L is rather too
% short than too long.

function [problem, lengths] = correlateSeries (problem, emulator, options)
  lengths = zeros (size (problem.value));
  at = problem.used(problem.estimateSeries(problem.used));
  if isempty (at)
    return
  end
  residual = NaN (size (problem.value));
  M = predictGap (emulator, [], calibrateNull (problem, emulator, options));
  used = problem.used;
  residual(used) = problem.value(used) - M(used);
  for s = unique (problem.series(at))
    points = at(problem.series(at) == s);
    % a quadratic leaves nothing of three points
    if numel (points) < 4
      continue
    end
    x = problem.coordinate(points);
    % centred and scaled: squares of seconds or micrometres lose digits
    u = (x - mean (x)) / max (std (x), realmin);
    degree = min (2, numel (unique (x)) - 1);
    r = residual(points) - polyval (polyfit (u, residual(points), degree), u);
    L = estimateCorrelation (r, problem.sd(points), x);
    lengths(problem.series == s & problem.estimateSeries) = L;
  end
  known = problem.covariance;
  sd = problem.sd;
  sd(~isfinite (sd)) = 0;
  problem.covariance = ...
    measurementCovariance (sd, problem.series, problem.coordinate, ...
                           lengths, problem.shared);
  if ~isempty (known)
    % what was stated of other series stays
    free = lengths' == 0 & lengths == 0;
    problem.covariance(free) = known(free);
  end
end

function L = estimateCorrelation (residual, sd, coordinate)
  L = 0;
  ok = isfinite (residual) & isfinite (coordinate) & sd > 0;
  z = residual(ok)(:) ./ sd(ok)(:);
  at = coordinate(ok)(:);
  steps = diff (unique (at));
  if numel (z) < 4 || isempty (steps) || ~any (z)
    return
  end
  lengths = logspace (log10 (min (steps) / 3), log10 (max (at) - min (at)), 60);
  D = abs (at - at');
  fit = arrayfun (@(l) correlationFit (z', exp (-D / l)), lengths);
  [best, i] = max (fit);
  % half of 3.84: likelihood ratio with one degree of freedom at 5 %
  if best - correlationFit (z', eye (numel (z))) > 1.92
    L = lengths(i);
  end
end

%!test
%! % errors alike over a third of the series are found, and only there (seeded)
%! rand ('twister', 7); randn ('twister', 7);
%! % two values at one place, one of another missing
%! x = linspace (0, 1, 30);
%! x(12) = x(11);
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
%! given.value(7) = NaN;
%! given.sd(7) = NaN;
%! given.estimateSeries = true (1, 60);
%! study = labStudy (given, data);
%! [problem, lengths] = correlateSeries (study.problem, study.emulator, ...
%!                                       study.hypotheses.options);
%! assert (lengths(1) > 0.04 && lengths(1) < 0.5);
%! assert (lengths(31), 0);
%! assert (problem.covariance(1, 2) > 0.004);
%! assert (problem.covariance(31, 32), 0);
%! assert (isfinite (problem.covariance(7, :)));
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
%! study = labStudy (given, data);
%! [~, lengths] = correlateSeries (study.problem, study.emulator, ...
%!                                 study.hypotheses.options);
%! assert (lengths, zeros (1, 12));

% SPDX-License-Identifier: GPL-3.0-only
