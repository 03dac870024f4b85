% FITBASELINE  Kriging of the runs without effects, and polynomials of it.
%
% CALL: EMULATOR = fitBaseline (EMULATOR, PROBLEM, DATA, ISBASE, OPTIONS, START)
%
%   EMULATOR    struct of fitEmulator; gets p to range, see there
%   PROBLEM, DATA, OPTIONS     see fitEmulator
%   ISBASE      n x 1 logical, runs of DATA with all effects neutral
%   START       1 x T surrogates of an earlier fit, [] = none

function emulator = fitBaseline (emulator, problem, data, isBase, options, start)
  p = columns (problem.limits);
  T = columns (data.Z);
  settings = struct ('covariance', options.covariance, ...
                     'trend', options.trend);
  emulator.range = rangesOf (problem, data.Z, isBase);
  for t = T:-1:1
    settings.name = problem.targetNames{t};
    settings.unit = emulator.range(t);
    if ~isempty (start)
      settings.start = start(t);
    end
    [X, z] = deal (data.X(isBase, :), data.Z(isBase, t));
    % coarse runs tell of the last level as far as one Kriging over both can say
    settings.level = data.level(isBase, t);
    fits(t) = fitSurrogate (X, z, problem.limits, settings);
  end
  emulator.p = p;
  emulator.limits = problem.limits;
  emulator.surrogates = fits;
  emulator.Q2 = [fits.Q2];
  % N (0, 1) where a surrogate knows how wrong it is; sideSignals looks at both
  emulator.looMean = arrayfun (@(s) mean (s.looStd.^2), fits);
  emulator.looMax = arrayfun (@(s) max (abs (s.looStd)), fits);
  % four points a term of the largest polynomial
  emulator.points = boxPoints (p, max (200, 4 * rows (polyPowers (p, 4))));
  X = fromSymmetric (emulator.points, emulator.limits);
  [average, emulator.surrogateVar] = predictSurrogate (fits, X);
  noise = [fits.noiseVar] + mean (emulator.surrogateVar);
  % the lowest degree whose error nobody sees: a fiftieth of noise and surrogate
  for degree = 2:4
    emulator.powers = polyPowers (p, degree);
    [emulator.coef, emulator.fitVar] = leastSquares (emulator.points, average, emulator.powers);
    if rows (emulator.powers) * 4 > rows (emulator.points) || ...
          all (emulator.fitVar < 0.02 * noise)
      break
    end
  end
  % variances need to be right within a factor only: a quadratic of their logarithm
  emulator.varPowers = polyPowers (p, 2);
end

% What the parameters move; of a response that they do not move, what effects or
% the measurement do.
function range = rangesOf (problem, Z, isBase)
  span = @(A) max (A, [], 1) - min (A, [], 1);
  range = span (Z(isBase, :));
  for t = find (range <= 100 * eps (max (abs (Z), [], 1)))
    range(t) = max (span ([Z(:, t); problem.value(t)]), problem.sd(t));
    if ~(range(t) > 0)
      range(t) = problem.unit(t);
    end
  end
end

function [coef, errorVar] = leastSquares (points, values, powers)
  B = polyRows (powers, points);
  coef = B \ values;
  n = rows (B);
  % unbiased, as many degrees of freedom as points less terms
  errorVar = sum ((values - B * coef).^2) / max (n - columns (B), 1);
end

%!test
%! % a response that only an effect moves has the range of that
%! lab = standInGap (0);
%! given = setfield (lab.problem, 'value', 8 * ones (1, 24));
%! data = lab.plan (12, 2);
%! data.level = zeros (size (data.Z));
%! off = all (data.E == 0, 2);
%! data.Z(:, 2) = 5 * ~off;
%! emulator = fitBaseline (struct (), newProblem (given), data, off, ...
%!                   gapOptions (struct ('trend', 'affine')), []);
%! assert (emulator.range(2), 8);
%! z = data.Z(off, 1);
%! assert (emulator.range(1), max (z) - min (z));

% SPDX-License-Identifier: GPL-3.0-only
