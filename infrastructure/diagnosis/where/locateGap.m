% LOCATEGAP  Answers WHERE the calibrated null model misses the measurements.
%
% CALL: WHERE = locateGap (STUDY)
%
%   STUDY    struct problem, emulator, hypotheses, fits: of newProblem, fitEmulator,
%            makeHypotheses, fitLibrary (first row: the measured values)
%   WHERE    struct
%     theta (1 x p in [-1, 1]), params (1 x p), chi2, p (lack of fit: share of
%       simulated data sets that leave more when they are fitted again, which
%       takes the freedom of the parameters into account)
%     absorbed, unabsorbed   parts of the misfit, by parityProjection
%     residual, sd, t, pTarget, absorbability, blind   1 x n, the used targets:
%       y - m, its standard deviation after fitting, their ratio, p-value
%       corrected for looking at n targets (max-T bootstrap), share of a
%       target's own error that parameters hide, and absorbability > 0.9
%     size   1 x n, |residual| in standard deviations of the noise of a target;
%       z divides by what the fit leaves of it, which says how sure a residual
%       is, not how large
%     benches (1 x B' struct: bench, p corrected for B' benches, size: root of
%       the sum of squares of its residuals in standard deviations of the noise)
%     conflict  struct bench (1 x B', benches with used targets), pair (B' x B':
%       p of bench j predicted from bench i), odd (the bench that conflicts with
%       all others, of which no two do; [] if there is none)
%     side (sideSignals)
%     budget (noiseBudget), held (struct z, mean, sd of the held-out targets, p
%       corrected for looking at all of them, as if their noises were apart)

function where = locateGap (study)
  problem = study.problem;
  emulator = study.emulator;
  hypotheses = study.hypotheses;
  white = hypotheses.white;
  used = white.columns;
  known = study.fits.calibrated;
  fit = struct ('Q', known.Q(1, :), 'U', known.U(1, :), 'chi2', known.chi2(1));
  where.theta = fit.Q;
  where.params = fromSymmetric (where.theta, problem.limits);
  where.chi2 = fit.chi2;
  [where.p, simulated] = lackOfFit (hypotheses, fit);
  [M, V, ~, J] = predictGap (white, [], where.theta);
  sd = sqrt (V');
  r = (study.fits.Z(1, :) - M)';
  J = reshape (vertcat (J{:})', columns (white.coef), emulator.p);
  parity = parityProjection (J ./ sd, r ./ sd);
  where.absorbed = parity.absorbed;
  where.unabsorbed = parity.unabsorbed;
  where = localise (where, rawErrors (white, V, J), r, simulated, ...
                    problem.bench(used), hypotheses.options);
  if isfield (hypotheses, 'alone')
    isOpen = ~hypotheses.alone.decides;
    where.p = max (max (where.p * isOpen, hypotheses.alone.p), eps (1));
    where.pTarget = max (max (where.pTarget * isOpen, hypotheses.alone.each), eps (1));
  end
  where.conflict = benchConflicts (study);
  where.side = sideSignals (problem, emulator, where.theta, hypotheses.options);
  where.budget = noiseBudget (problem, emulator);
  where.held = heldOut (study);
end

% Simulated data sets, fitted again; LEFT (repeats x T', whitened): what of them
% is not met.
function [p, left] = lackOfFit (hypotheses, fit)
  white = hypotheses.white;
  options = hypotheses.options;
  noise = integrationPoints (options.bootstrap, columns (white.coef), ...
                             options.seed).normal;
  restore = seedRandom (options.seed);
  noise = noise .* errorFactors (white, options.bootstrap);
  clear restore;
  [M, V] = predictGap (white, [], fit.Q);
  Z = M + sqrt (V) .* noise;
  flat = setfield (hypotheses.prior, 'flat', true);
  again = fitHypothesis (white, newHypothesis ('null'), Z, ...
                         repmat (fit.U, options.bootstrap, 1), flat);
  % the measurement is one of the data sets: no p of 0 (Davison and Hinkley 1997, 4.2)
  p = (1 + sum (again.chi2 >= fit.chi2 - options.fitMargin)) / ...
      (options.bootstrap + 1);
  left = Z - predictGap (white, [], again.Q);
end

% Covariances in the units of the targets: Sigma, and Omega after the fit.
function errors = rawErrors (white, V, J)
  errors.back = white.back;
  errors.Sigma = errors.back * diag (V) * errors.back';
  Jraw = errors.back * J;
  % parameters that no target sees have no variance to pass on
  C = pinv (J' * diag (1 ./ V) * J);
  errors.Omega = errors.Sigma - Jraw * C * Jraw';
end

function where = localise (where, errors, r, simulated, bench, limits)
  where.residual = (errors.back * r)';
  variance = diag (errors.Omega)';
  total = diag (errors.Sigma)';
  where.absorbability = 1 - max (variance, 0) ./ total;
  where.blind = where.absorbability > limits.blindAt;
  % what is left after a fit in a bounded box scatters more than the slopes say
  fake = simulated * errors.back';
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
  where.benches = misfitOfBenches (errors.Omega ./ (unit' * unit), ...
                                   where.residual ./ unit, sure ./ unit, ...
                                   fake .* where.sd ./ unit, bench);
end

% All in standard deviations of each target, whose units differ.
function benches = misfitOfBenches (Omega, residual, sure, fake, bench)
  groups = unique (bench);
  misfit = zeros (1, numel (groups));
  fakes = zeros (rows (fake), numel (groups));
  for b = 1:numel (groups)
    at = bench == groups(b);
    % directions that the fit has taken up tell nothing of a bench
    inner = pinv (Omega(at, at), 1e-3);
    misfit(b) = residual(at) * inner * residual(at)';
    fakes(:, b) = sum ((fake(:, at) * inner) .* fake(:, at), 2);
    if ~any (inner(:))
      % the parameters can move these targets anywhere, but for their limits
      misfit(b) = sumsq (sure(at));
      fakes(:, b) = sumsq (fake(:, at), 2);
    end
  end
  benches = benchTests (groups, misfit, fakes);
  for b = 1:numel (groups)
    benches(b).size = norm (residual(bench == groups(b)));
  end
end

% Benches of different size are compared by their rank among the simulations.
function benches = benchTests (groups, misfit, fakes)
  B = rows (fakes);
  [~, order] = sort (-fakes, 1);
  ranks = zeros (size (fakes));
  for b = 1:numel (groups)
    ranks(order(:, b), b) = (1:B)' / B;
  end
  least = min (ranks, [], 2);
  benches = struct ('bench', {}, 'p', {});
  for b = 1:numel (groups)
    alone = (1 + sum (fakes(:, b) >= misfit(b))) / (B + 1);
    p = (1 + sum (least <= alone)) / (B + 1);
    benches(b) = struct ('bench', groups(b), 'p', min (p, 1));
  end
end

function conflict = benchConflicts (study)
  problem = study.problem;
  used = problem.used;
  conflict.bench = unique (problem.bench(used));
  n = numel (conflict.bench);
  conflict.pair = NaN (n);
  of = @(b) used(problem.bench(used) == conflict.bench(b));
  for b = 1:n
    for a = setdiff (1:n, b)
      conflict.pair(a, b) = crossPredict (study, of (a), of (b)).p;
    end
  end
  conflict.odd = [];
  % predicted either way: the surer side may show what the other hides
  clash = min (conflict.pair, conflict.pair') < study.hypotheses.options.conflictAt;
  % of two nobody can say which is odd
  for b = 1:n * (n > 2)
    others = setdiff (1:n, b);
    if all (clash(b, others)) && ~any (any (clash(others, others)))
      conflict.odd = conflict.bench(b);
    end
  end
end

function held = heldOut (study)
  problem = study.problem;
  held = struct ('z', [], 'mean', [], 'sd', [], 'p', []);
  if ~isempty (problem.heldOut)
    cross = crossPredict (study, problem.used, problem.heldOut);
    held.mean = cross.mean;
    held.sd = cross.sd;
    held.z = (problem.value(problem.heldOut) - cross.mean) ./ cross.sd;
    each = 2 * normalTail (abs (held.z));
    % of the largest of several (Sidak 1967); expm1 keeps the digits of a small p
    held.p = -expm1 (numel (each) * log1p (-each));
  end
end

%!test
%! % an error of one bench is found there and nowhere else
%! quick = struct ('bootstrap', 199);
%! rand ('twister', 5); randn ('twister', 5);
%! lab = standInGap (0);
%! given = lab.problem;
%! given.value = lab.means (0.4 * ones (1, 4), zeros (1, 10)) ...
%!           + sqrt (2) * lab.noiseSd .* randn (1, 24);
%! given.value(9) = given.value(9) + 5;
%! data = lab.plan (40, 2);
%! where = locateGap (labStudy (given, data, quick));
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
%! % a bench that reads wrongly as a whole is the odd one
%! given.value(7:12) = given.value(7:12) + 6;
%! conflict = locateGap (labStudy (given, data, quick)).conflict;
%! assert (conflict.odd, 2);
%! assert (isnan (diag (conflict.pair)));
%! given.value(7:12) = given.value(7:12) - 6;
%! % in another unit it is there too
%! given.value(9) = 1e-4 * given.value(9);
%! given.sd(9) = 1e-4 * given.sd(9);
%! data.Z(:, 9) = 1e-4 * data.Z(:, 9);
%! other = locateGap (labStudy (given, data, quick));
%! assert ([other.benches.p], [where.benches.p], 0.03);
%! assert ([other.benches.size], [where.benches.size], 0.1);
%! assert (other.size, where.size, 0.1);
%!test
%! % as many parameters as targets: an error that they can hide is no gap, one
%! % out of their reach is, and its bench is named
%! given = struct ('value', [0, 0], 'sd', [1, 1], 'limits', [0, 0; 1, 1], ...
%!                 'bench', [1, 2]);
%! rand ('twister', 3);
%! X = rand (40, 2);
%! data = struct ('X', X, 'E', zeros (40, 0), 'replicate', ones (40, 1), ...
%!                'Z', 20 * X + 0.01 * randn (40, 2));
%! quick = struct ('bootstrap', 199);
%! p = zeros (2, 3);
%! for k = 1:2
%!   given.value = [7, 12 + 30 * (k - 1)];
%!   where = locateGap (labStudy (given, data, quick));
%!   p(k, :) = [where.p, where.pTarget(2), where.benches(2).p];
%! end
%! assert (p(1, :) > 0.9);
%! assert (p(2, :) < 0.05);

% SPDX-License-Identifier: GPL-3.0-only
