% LEARNEFFECT  Learns from its runs what one effect adds to every response.
%
% CALL: E = learnEffect (EM, EFFECT, RUNS)
%
%   EM      struct of fitEmulator: baseline and noise
%   EFFECT  struct of newEffect
%   RUNS    struct theta (n x p, parameters in [-1, 1]), phi (n x 1, strength),
%           Z (n x T, results, NaN = none), mean and variance (n x T, what the
%           baseline predicts)
%   E       struct name, range, scale, laboratory, runs (number), Q (n x (p +
%             1), theta and phi), Z, R (Z less mean), variance
%             bend       exponent: everything is a polynomial in the parameters
%                        and psi = sign (phi) |phi|^bend
%             powers, coef (q x T)         mean, psi in each term
%             points, varOverPsi2 (M x T)  variance over psi^2, misfit in it
%             varPowers                    quadratic for its logarithm
%             looStd (1 x T cell)
%             unbent     1: too few runs to tell the bend, see predictHypothesis
%             strongest            largest |phi| of the runs
%
% The error of the baseline is smooth in the parameters and the same in all
% runs: left to the effect it would come back as a signature that every
% measurement has. It stands in the covariance of the runs (fitEffect).
%
% Liquid bridges and cohesion saturate, SJKR and vibration have a dead zone: the
% bend, one for all responses since it is the effect's, maximises their joint
% marginal likelihood, with a weak prior for none.

function e = learnEffect (em, effect, runs)
  T = columns (em.coef);
  Q = [runs.theta, runs.phi];
  e = struct ('name', effect.name, 'range', effect.range, ...
              'scale', effect.scale, 'laboratory', effect.laboratory, ...
              'runs', sum (any (isfinite (runs.Z), 2)), 'Q', Q, ...
              'Z', runs.Z, 'R', runs.Z - runs.mean, ...
              'variance', runs.variance, ...
              'bend', 1, ...
              'success', [], 'unbent', 0, ...
              'strongest', max ([abs(Q(:, end)); 0.1]));
  e.varPowers = polyPowers (em.p + 1, 2);
  e.points = boxPoints (em.p + 1, 6 * rows (e.varPowers));
  e.points(:, end) = e.range(1) + (e.points(:, end) + 1) / 2 * diff (e.range);
  e.looStd = repmat ({zeros(0, 1)}, 1, T);
  if effect.laboratory
    e.powers = [em.powers, ones(rows (em.powers), 1)];
    e.coef = em.coef * effect.matrix;
    e.coef(1, :) = e.coef(1, :) + effect.offset;
    e.varOverPsi2 = zeros (rows (e.points), T);
    return
  end
  e.powers = polyPowers (em.p + 1, 3);
  e.powers = e.powers(e.powers(:, end) > 0, :);
  e.unbent = e.runs < 8;
  if ~e.unbent
    e.bend = bestBend (e, em.noiseVar);
  end
  Q = bent (Q, e.bend);
  e.coef = zeros (rows (e.powers), T);
  B = polyRows (e.powers, e.points) ./ e.points(:, end);
  for t = 1:T
    ok = isfinite (e.R(:, t));
    if any (ok)
      fit = fitEffect (e.powers, Q(ok, :), [e.R(ok, t), Q(ok, end)], ...
                       em.noiseVar(t), e.variance(ok, t));
    else
      first = sum (e.powers, 2) == 1;
      fit = struct ('coef', zeros (rows (e.powers), 1), 'misfit', 0, ...
                    'looStd', zeros (0, 1), ...
                    'covariance', em.range(t)^2 * diag (first));
    end
    e.coef(:, t) = fit.coef;
    e.looStd{t} = fit.looStd;
    e.varOverPsi2(:, t) = max (sum ((B * fit.covariance) .* B, 2), ...
                               (1e-8 * em.range(t))^2) + fit.misfit;
  end
end

function Q = bent (Q, bend)
  Q(:, end) = sign (Q(:, end)) .* abs (Q(:, end)).^bend;
end

function bend = bestBend (e, noiseVar)
  grid = [0.3, 0.45, 0.65, 1, 1.5, 2.2, 3.3];
  coarse = struct ('decay', 0.3, 'misfit', [0, 8]);
  score = -0.5 * log (grid).^2;
  for b = 1:numel (grid)
    Q = bent (e.Q, grid(b));
    for t = 1:numel (noiseVar)
      ok = isfinite (e.R(:, t));
      if sum (ok) > 3
        fit = fitEffect (e.powers, Q(ok, :), [e.R(ok, t), Q(ok, end)], ...
                         noiseVar(t), e.variance(ok, t), coarse);
        score(b) = score(b) + fit.score;
      end
    end
  end
  [~, best] = max (score);
  bend = grid(best);
end

%!test
%! % saturation and dead zone are told from straight effects (seeded)
%! rand ('twister', 5); randn ('twister', 5);
%! em = struct ('p', 1, 'coef', zeros (3, 6), 'powers', [0; 1; 2], ...
%!              'noiseVar', 0.01 * ones (1, 6), 'range', ones (1, 6));
%! em.correlation = eye (6);
%! effect = struct ('name', 'e', 'range', [0, 1], 'scale', 0.5, ...
%!                  'laboratory', false);
%! Q = [2 * rand(20, 1) - 1, 0.1 + 0.9 * rand(20, 1)];
%! size_ = [3, -2, 2, 4, -3, 2];
%! for c = [0.4, 1, 3]
%!   Z = Q(:, 2).^c .* size_ .* (1 + 0.2 * Q(:, 1)) + 0.1 * randn (20, 6);
%!   runs = struct ('theta', Q(:, 1), 'phi', Q(:, 2), 'Z', Z, ...
%!                  'mean', 0 * Z, 'variance', 0 * Z);
%!   e = learnEffect (em, effect, runs);
%!   assert (abs (log (e.bend / c)) < 0.6);
%!   middle = polyRows (e.powers, [0, 0.5^e.bend]) * e.coef;
%!   assert (middle, 0.5^c * size_, 0.35);
%! end
