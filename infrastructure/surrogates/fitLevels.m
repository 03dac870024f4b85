% FITLEVELS  Kriging model of a response that was run at several levels.
%
% CALL: S = fitLevels (X, Z, LEVEL, LIMITS, OPTIONS)
%
%   X        n x d, parameter sets
%   Z        n x 1, responses (NaN: failed)
%   LEVEL    n x 1, how coarse each run is: 0 where runs count (unitLevel)
%   LIMITS   2 x d, the box
%   OPTIONS  of fitSurrogate
%   S        struct of fitSurrogate with the level as an input; dropped: levels
%            whose runs it does not hold (1 x k, as LEVEL)
%
% One Kriging model over parameters and level, so that coarse runs tell of fine
% ones as far as they are alike (Kennedy and O'Hagan 2000 for the idea; here one
% smooth covariance, as the levels are values of one variable). From two runs
% that count on, the levels are dropped, coarsest first, where the runs are
% likelier as two responses that have nothing in common: where the log
% likelihood of the coarse runs alone and the others alone exceeds that of all
% together by 3 (see likelihoodOf).

function s = fitLevels (X, z, level, limits, options)
  ok = isfinite (z);
  options.extra = level;
  s = fitSurrogate (X, z, limits, options);
  if sum (ok & level <= 0) < 2 || isConstant (s.z)
    return
  end
  together = likelihoodOf (s, X(ok, :), z(ok), level(ok), s);
  for cut = sort (unique (level(ok & level > 0)), 'descend')'
    keep = ok & level < cut;
    quick = struct ('trend', s.trend, 'covariance', s.covariance);
    coarse = fitRows (X, z, level, ok & ~keep, limits, quick);
    fine = fitRows (X, z, level, keep, limits, quick);
    apart = likelihoodOf (coarse, X(ok & ~keep, :), z(ok & ~keep), ...
                          level(ok & ~keep), s) + ...
            likelihoodOf (fine, X(keep, :), z(keep), level(keep), s);
    if apart > together + 3
      s = fitRows (X, z, level, keep, limits, struct ('name', s.name));
      s.dropped = unique (level(ok & ~keep))';
      return
    end
  end
end

% Log likelihood of runs by the parameters of surrogate S. The coefficients of
% its trend are normal about the mean of all runs, with 3 times their standard
% deviation: with a flat prior, models of different runs could not be compared.
% Where S has less than d + 3 runs, parameters of its own would be guesswork:
% those of the model of all runs (WHOLE) take their place.
function L = likelihoodOf (s, X, z, level, whole)
  n = numel (z);
  d = columns (X);
  source = s;
  if n < d + 3
    source = whole;
  end
  U = unitInputs ([X, level], s.limits, columns (source.extra));
  H = feval (source.model.lm, U);
  m = source.model;
  K = source.scale^2 * feval (m.covariance_type, m.param, U, U) + ...
      (3 * whole.scale)^2 * (H * H');
  R = chol (K + diag (noiseAt (source, level) + 1e-9 * whole.scale^2));
  v = R' \ (z - whole.shift);
  L = -0.5 * (v' * v) - sum (log (diag (R))) - n / 2 * log (2 * pi);
end

%!shared X, level, lim, truth
%! rand ('twister', 5);
%! randn ('twister', 5);
%! X = rand (20, 2);
%! level = [ones(8, 1); 0.5; zeros(11, 1)];
%! lim = [0, 0; 1, 1];
%! truth = @(X) 1 + X(:, 1) + X(:, 2).^2;

%!test
%! % coarse runs that are off by a fifth and bent tell of the fine ones
%! z = truth (X) .* (1 + 0.2 * level .* (1 + X(:, 1)));
%! few = [1:9, 18:20];
%! s = fitLevels (X(few, :), z(few), level(few), lim, struct ());
%! assert (isempty (s.dropped));
%! V = rand (50, 2);
%! [m, v] = predictSurrogate (s, V);
%! assert (mean (abs (m - truth (V))) < 0.06);
%! assert (mean (abs (m - truth (V)) < 2 * sqrt (v)) > 0.9);
%! assert (predictSurrogate (s, [V(1, :), 1]), ...
%!         truth (V(1, :)) * (1.2 + 0.2 * V(1)), 0.1);

%!test
%! % a level that tells nothing is dropped, one that helps is not
%! z = truth (X) + 0.01 * randn (20, 1);
%! s = fitLevels (X, z, level, lim, struct ());
%! assert (isempty (s.dropped));
%! z(1:8) = 1 + 3 * rand (8, 1);
%! s = fitLevels (X, z, level, lim, struct ('name', 'mass'));
%! assert (s.dropped, 1);
%! assert (s.name, 'mass');
%! assert (predictSurrogate (s, [0.4, 0.6]), truth ([0.4, 0.6]), 0.05);

% SPDX-License-Identifier: GPL-3.0-only
