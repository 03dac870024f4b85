% LOCATEGAP  Answers WHERE the calibrated null model misses the measurements.
%
% CALL: WHERE = locateGap (GAPPROBLEM, EM, MODELS, FITS, OPTIONS)
%
%   GAPPROBLEM, EM, MODELS  of newGapProblem, fitEmulator, makeHypotheses
%   FITS                    of fitLibrary for the measured values (first row)
%   OPTIONS                 of gapOptions
%   WHERE    struct
%     theta (1 x p in [-1, 1]), params (1 x p), chi2, p (lack of fit, bootstrap
%       with refit), pChi2 (the same from the chi-square table)
%     absorbed, unabsorbed   parts of the misfit, by parityProjection
%     residual, sd, t, pTarget, absorbability, blind   1 x n of GAPPROBLEM.used:
%       y - m, its standard deviation after fitting, their ratio, p-value
%       corrected for looking at n targets (max-T bootstrap), share of a
%       target's own error that parameters hide, and absorbability > 0.9
%     size   1 x n, |residual| in standard deviations of the noise of a target;
%       z divides by what the fit leaves of it, which says how sure a residual
%       is, not how large
%     benches (1 x B' struct: bench, p corrected for B' benches, size: root of
%       the sum of squares of its residuals in standard deviations of the noise)
%     conflict (benchConflicts), trends (trendContrasts), side (sideSignals)
%     budget (noiseBudget), held (struct z, mean, sd of the held-out targets, p
%       corrected for looking at all of them, as if their noises were apart)
%
% See also: screenEffects, caseEvidence, diagnoseMatrices

function where = locateGap (gapProblem, em, models, fits, options)
  white = models.white;
  used = white.columns;
  fit = struct ('Q', fits.calibrated.Q(1, :), 'U', fits.calibrated.U(1, :), ...
                'chi2', fits.calibrated.chi2(1));
  where.theta = fit.Q;
  where.params = mean (gapProblem.limits) + ...
                 where.theta .* diff (gapProblem.limits) / 2;
  where.chi2 = fit.chi2;
  test = lackOfFit (models, fit, struct ('repeats', options.bootstrap, ...
                                         'seed', options.seed));
  where.p = test.p;
  [M, V, ~, J] = predictGap (white, [], where.theta);
  sd = sqrt (V');
  r = (fits.Z(1, :) - M)';
  J = reshape (vertcat (J{:})', numel (used), em.p);
  parity = parityProjection (J ./ sd, r ./ sd);
  where.pChi2 = chiSquareTail (where.chi2, max (numel (parity.rho), 1));
  where.absorbed = parity.absorbed;
  where.unabsorbed = parity.unabsorbed;
  view = rawView (white, V, J);
  where = localise (where, view, r, test.residual, gapProblem.bench(used), ...
                    options);
  where.conflict = benchConflicts (gapProblem, em, models);
  where.trends = trendContrasts (gapProblem, used, where.residual', view);
  where.side = sideSignals (gapProblem, em, where.theta);
  where.budget = noiseBudget (gapProblem, em);
  where.held = heldOut (gapProblem, em, models);
end

% Covariances in the units of the targets: Sigma, and Omega after the fit.
function view = rawView (white, V, J)
  view.back = white.back;
  view.Sigma = view.back * diag (V) * view.back';
  Jraw = view.back * J;
  C = pinv (J' * diag (1 ./ V) * J);
  view.Omega = view.Sigma - Jraw * C * Jraw';
end

function where = localise (where, view, r, simulated, bench, limits)
  where.residual = (view.back * r)';
  variance = diag (view.Omega)';
  total = diag (view.Sigma)';
  where.absorbability = 1 - max (variance, 0) ./ total;
  where.blind = where.absorbability > limits.blindAt;
  % what is left after a fit in a bounded box scatters more than the slopes say
  fake = simulated * view.back';
  where.sd = sqrt (max ([variance; mean(fake.^2, 1); 1e-3 * total], [], 1));
  where.t = where.residual ./ where.sd;
  fake = fake ./ where.sd;
  top = max (abs (fake), [], 2);
  % less than what the fit may leave by ending early
  sure = sqrt (max (where.residual.^2 - limits.fitMargin * total, 0));
  for i = 1:numel (where.t)
    where.pTarget(i) = (1 + sum (top >= sure(i) / where.sd(i))) / ...
                       (numel (top) + 1);
  end
  unit = sqrt (total);
  where.size = abs (where.residual) ./ unit;
  where.benches = misfitOfBenches (view.Omega ./ (unit' * unit), ...
                                   where.residual ./ unit, sure ./ unit, ...
                                   fake .* where.sd ./ unit, bench);
end

% All in standard deviations of each target, whose units differ.
function benches = misfitOfBenches (Omega, residual, sure, fake, bench)
  groups = unique (bench);
  own = zeros (1, numel (groups));
  fakes = zeros (rows (fake), numel (groups));
  for b = 1:numel (groups)
    at = bench == groups(b);
    inner = pinv (Omega(at, at), 1e-3);
    own(b) = residual(at) * inner * residual(at)';
    fakes(:, b) = sum ((fake(:, at) * inner) .* fake(:, at), 2);
    if ~any (inner(:))
      % the parameters can move these targets anywhere, but for their limits
      own(b) = sumsq (sure(at));
      fakes(:, b) = sumsq (fake(:, at), 2);
    end
  end
  benches = benchTests (groups, own, fakes);
  for b = 1:numel (groups)
    benches(b).size = norm (residual(bench == groups(b)));
  end
end

% Benches of different size are compared by their rank among the simulations.
function benches = benchTests (groups, own, fakes)
  B = rows (fakes);
  [~, order] = sort (-fakes, 1);
  ranks = zeros (size (fakes));
  for b = 1:numel (groups)
    ranks(order(:, b), b) = (1:B)' / B;
  end
  least = min (ranks, [], 2);
  benches = struct ('bench', {}, 'p', {});
  for b = 1:numel (groups)
    alone = (1 + sum (fakes(:, b) >= own(b))) / (B + 1);
    p = (1 + sum (least <= alone)) / (B + 1);
    benches(b) = struct ('bench', groups(b), 'p', min (p, 1));
  end
end

function held = heldOut (gapProblem, em, models)
  held = struct ('z', [], 'mean', [], 'sd', [], 'p', []);
  if ~isempty (gapProblem.heldOut)
    cross = crossPredict (gapProblem, em, models, gapProblem.used, ...
                          gapProblem.heldOut);
    held.mean = cross.mean;
    held.sd = cross.sd;
    held.z = (gapProblem.value(gapProblem.heldOut) - cross.mean) ./ cross.sd;
    own = 2 * normalTail (abs (held.z));
    held.p = -expm1 (numel (own) * log1p (-own));
  end
end

%!test
%! % an error of one bench is found there and nowhere else
%! rand ('twister', 5); randn ('twister', 5);
%! lab = standInGap (0);
%! given = lab.gapProblem;
%! given.value = lab.means (0.4 * ones (1, 4), zeros (1, 10)) ...
%!           + sqrt (2) * lab.noiseSd .* randn (1, 24);
%! given.value(9) = given.value(9) + 5;
%! gapProblem = newGapProblem (given);
%! options = gapOptions (struct ('bootstrap', 199, 'trend', 'affine'));
%! data = lab.plan (40, 2);
%! em = fitEmulator (gapProblem, data, options);
%! models = makeHypotheses (gapProblem, em, options);
%! fits = fitLibrary (models, given.value);
%! where = locateGap (gapProblem, em, models, fits, options);
%! assert (where.p < 0.02);
%! [~, worst] = max (abs (where.t));
%! assert (worst, 9);
%! [~, worst] = max (where.size);
%! assert (worst, 9);
%! assert (where.pTarget(9) < 0.02);
%! assert (where.benches(2).p < 0.05);
%! [~, worst] = max ([where.benches.size]);
%! assert (worst, 2);
%! assert (isempty (where.held.z));
%! % in another unit it is there too
%! given.value(9) = 1e-4 * given.value(9);
%! given.sd(9) = 1e-4 * gapProblem.sd(9);
%! data.Z(:, 9) = 1e-4 * data.Z(:, 9);
%! gapProblem = newGapProblem (given);
%! em = fitEmulator (gapProblem, data, options);
%! models = makeHypotheses (gapProblem, em, options);
%! fits = fitLibrary (models, given.value);
%! other = locateGap (gapProblem, em, models, fits, options);
%! assert ([other.benches.p], [where.benches.p], 0.03);
%! assert ([other.benches.size], [where.benches.size], 0.1);
%! assert (other.size, where.size, 0.1);
%!test
%! % as many parameters as targets: an error that they can hide is no gap, one
%! % out of their reach is, and its bench is named
%! gapProblem = newGapProblem (struct ('value', [0, 0], 'sd', [1, 1], ...
%!                                     'limits', [0, 0; 1, 1], ...
%!                                     'bench', [1, 2]));
%! rand ('twister', 3);
%! X = rand (40, 2);
%! data = struct ('X', X, 'E', zeros (40, 0), 'replicate', ones (40, 1), ...
%!                'Z', 20 * X + 0.01 * randn (40, 2));
%! options = gapOptions (struct ('bootstrap', 199, 'trend', 'affine'));
%! p = zeros (2, 3);
%! for k = 1:2
%!   gapProblem.value = [7, 12 + 30 * (k - 1)];
%!   em = fitEmulator (gapProblem, data, options);
%!   models = makeHypotheses (gapProblem, em, options);
%!   fits = fitLibrary (models, gapProblem.value);
%!   where = locateGap (gapProblem, em, models, fits, options);
%!   p(k, :) = [where.p, where.pTarget(2), where.benches(2).p];
%! end
%! assert (p(1, :) > 0.9);
%! assert (p(2, :) < 0.05);
