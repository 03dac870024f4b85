% CASEEVIDENCE  Computes the evidence of every hypothesis for one data set.
%
% CALL: EVIDENCE = caseEvidence (HYPOTHESES, FITS, I)
%
%   HYPOTHESES  struct of makeHypotheses
%   FITS       struct of fitLibrary
%   I          scalar, row of the data set
%   EVIDENCE   struct; H hypotheses: null, singles, pairs of the likeliest,
%              discrepancies
%     kind (1 x H cell), members (1 x H cell: effects), logPrior, logE, error,
%     ess (1 x H; NaN where Laplace's formula was enough, see below)
%     phi (H x 1: median of the first strength)
%     atLimit (1 x H, posterior mass glued to the end of the range of a
%       strength)
%     turned (1 x H, posterior mass of an error of form with a tangent above
%       options.turnedAt: then what it does is rather another cause's)
%     posterior (1 x H cell: Q, weight: samples of each hypothesis)
%     vague (1 x K, variance that comes with the surrogate of the effect where
%       it fits best alone, over all noise, in the mean of the targets)
%     gate (struct of gapTest), screen (struct of screenEffects)
%
% Integrated are the null model, every single effect, and all others that
% Laplace's formula gives more than a ten-thousandth of the probability.

function evidence = caseEvidence (hypotheses, fits, i)
  z = fits.Z(i, :);
  evidence.screen = screenEffects (hypotheses.white, fits.calibrated.Q(i, :), z);
  evidence.gate = gapTest (hypotheses, fits.logE(i, :));
  list = listHypotheses (hypotheses, fits, i, evidence);
  logP = [list.logPrior] + [list.logE];
  logP = logP - logSumExp (logP);
  for j = 1:numel (list)
    % exp (-9.2) is a ten-thousandth: what is less likely decides nothing
    if any (strcmp (list(j).h.kind, {'null', 'single'})) || logP(j) > -9.2
      list(j) = integrate (hypotheses, list(j));
    end
  end
  evidence = collect (evidence, list);
  evidence.vague = vagueOf (hypotheses, fits, i);
end

function evidence = collect (evidence, list)
  each = [list.h];
  evidence.kind = {each.kind};
  evidence.members = {each.members};
  for field = {'logPrior', 'logE', 'error', 'ess', 'atLimit', 'turned'}
    evidence.(field{1}) = [list.(field{1})];
  end
  evidence.phi = vertcat (list.phi);
  evidence.posterior = {list.posterior};
end

% Where it is emulated badly, an effect is unlikely for that, or likely.
function vague = vagueOf (hypotheses, fits, i)
  white = hypotheses.white;
  vague = zeros (1, numel (hypotheses.singles));
  at = white.isTarget > 0;
  for k = 1:numel (vague)
    Q = fits.of{hypotheses.singles(k)}.Q(i, 1:white.p + 1);
    [~, V] = predictGap (white, k, Q);
    [~, V0] = predictGap (white, [], Q(1:white.p));
    vague(k) = mean (V(at) ./ V0(at)) - 1;
  end
end

function one = integrate (hypotheses, one)
  settings = hypotheses.options;
  settings.prior = hypotheses.prior;
  r = integrateEvidence (one.white, one.h, one.z, one.modes, settings);
  % with fewer measured values than parameters a sample may say nothing; then
  % the first estimate stays, and an effective size of 0 says what it is worth
  isEmpty = ~(sum (r.weight) > 0) || ~isfinite (r.logE);
  if isEmpty
    one.ess = 0;
    return
  end
  one.logE = r.logE;
  one.error = r.error;
  one.ess = r.ess;
  one.posterior = struct ('Q', r.Q, 'weight', r.weight, ...
                          'cautious', r.cautious);
  members = one.h.members;
  if isempty (members)
    return
  end
  p = one.white.p;
  range = vertcat (one.white.effect(members).range);
  one.phi = weightedQuantile (r.Q(:, p + 1), r.weight, 0.5);
  lo = range(:, 1)';
  hi = range(:, 2)';
  margin = (1 - settings.limitAt) * (hi - lo);
  phi = r.Q(:, p + (1:numel (members)));
  % at 0 a strength is at no limit: there the effect is not
  ends = phi > hi - margin | (lo < 0 & phi < lo + margin);
  one.atLimit = max (r.weight' * ends);
  % the weights add up to one, to a digit: no probability below 0
  one.turned = min (r.weight' * (r.Q(:, end) > settings.turnedAt), 1);
end

% All hypotheses for data set I, by Laplace's formula: the rows of HYPOTHESES.list
% and, behind the single effects, pairs: h (newHypothesis), white, z (the data
% in its coordinates), modes (struct U, A), and what is collected.
% Pairs, where there may be a gap: each of the two likeliest effects with the
% four whose signatures take most out of what it leaves. All pairs share the
% prior probability of pairs, also those that are not tried.
function list = listHypotheses (hypotheses, fits, i, evidence)
  for j = numel (hypotheses.list):-1:1
    row = hypotheses.list(j);
    list(j) = entry (row.h, row.white, row.prior, fits.of{j}, i);
  end
  singles = hypotheses.singles;
  if numel (singles) > 1 && evidence.gate.p < 2 * hypotheses.options.significance
    pairs = pairsOf (hypotheses, fits, i, evidence.screen);
    list = [list(1:singles(end)), pairs, list(singles(end) + 1:end)];
  end
end

function one = entry (h, white, prior, fit, i)
  one = struct ('h', h, 'white', white, 'z', fit.Z(i, :), ...
                'modes', modesOf (fit, i), ...
                'logPrior', log (prior), 'logE', fit.logSum(i), ...
                'error', NaN, 'ess', NaN, 'phi', NaN, 'atLimit', 0, ...
                'turned', 0, ...
                'posterior', struct ('Q', [], 'weight', [], 'cautious', []));
end

function modes = modesOf (fit, i)
  d = columns (fit.U);
  modes = struct ('U', fit.U(i, :), 'A', reshape (fit.A(i, :, :), d, d));
  if fit.hasOther(i)
    modes(2) = struct ('U', fit.other.U(i, :), ...
                       'A', reshape (fit.other.A(i, :, :), d, d));
  end
end

function list = pairsOf (hypotheses, fits, i, screen)
  singles = hypotheses.singles;
  [~, order] = sort (-fits.logE(i, singles));
  pairs = zeros (0, 2);
  for k = order(1:2)
    M = predictGap (hypotheses.white, k, fits.of{singles(k)}.Q(i, :));
    others = partnersOf (k, fits.Z(i, :) - M, screen);
    pairs = [pairs; repmat(k, numel (others), 1), others(:)];
  end
  pairs = unique (sort (pairs, 2), 'rows');
  for m = rows (pairs):-1:1
    fit = fitEffects (hypotheses, fits, i, pairs(m, :), hypotheses.prior);
    list(m) = entry (newHypothesis ('pair', pairs(m, :)), hypotheses.white, ...
                     hypotheses.pairPrior(pairs(m, 1), pairs(m, 2)), fit, 1);
  end
end

% By what their signatures explain of the residual R of effect K.
function others = partnersOf (k, r, screen)
  rho = screen.parity.N' * r';
  % at right angles to K itself: what it leaves is for the other one to explain
  along = screen.U(:, k) / max (norm (screen.U(:, k)), realmin);
  rest = screen.U - along * (along' * screen.U);
  % what is left of a signature that is the same but for rounding says nothing
  least = max (1e-16 * sum (screen.U.^2, 1), realmin);
  gain = (rest' * rho).^2 ./ max (sum (rest.^2, 1), least)';
  gain(k) = -Inf;
  [~, order] = sort (-gain);
  others = order(1:min (4, numel (gain) - 1));
end

%!test
%! % evidence of the null model against the closed form: three targets without
%! % parameter, one direction integrated over the box
%! hypotheses = handMadeHypotheses ();
%! evidence = caseEvidence (hypotheses, fitLibrary (hypotheses, [1.5, 0.5, 0, 0]), 1);
%! exact = -2 * log (2 * pi) + 0.5 * log (2 * pi / 10) - log (2) ...
%!         + log (normalTail (-1.5 * sqrt (10)) - normalTail (sqrt (10) / 2));
%! assert (evidence.logE(1), exact, 5 * evidence.error(1));
%! assert (evidence.kind([1, 2, 3]), {'null', 'single', 'single'});
%! assert (evidence.kind{4}, 'discrepancy');
%!test
%! % a strong signal along effect a: it wins, its strength is found
%! hypotheses = handMadeHypotheses ();
%! hypotheses.reference = zeros (99, 1);
%! evidence = caseEvidence (hypotheses, fitLibrary (hypotheses, [1.5, 0.5, 3, 3]), 1);
%! assert (evidence.kind, {'null', 'single', 'single', 'pair', 'discrepancy'});
%! assert (evidence.vague, [0, 0], 1e-12);
%! assert (sum (exp (evidence.logPrior)), 1, 1e-12);
%! [~, best] = max (evidence.logPrior + evidence.logE);
%! assert (evidence.members{best}, 1);
%! assert (evidence.phi(best), 0.7, 0.1);
%!test
%! % a misfit along no effect: a discrepancy wins over null and effects
%! hypotheses = handMadeHypotheses ();
%! evidence = caseEvidence (hypotheses, fitLibrary (hypotheses, [1.5, 0.5, -6, 5]), 1);
%! [~, best] = max (evidence.logPrior + evidence.logE);
%! assert (evidence.kind{best}, 'discrepancy');
%!test
%! % reproducible, and hardly moved by the seed of the integration
%! hypotheses = handMadeHypotheses ();
%! fits = fitLibrary (hypotheses, [1.5, 0.5, 3, 3]);
%! evidence = caseEvidence (hypotheses, fits, 1);
%! assert (caseEvidence (hypotheses, fits, 1).logE, evidence.logE);
%! hypotheses.options.seed = 2;
%! other = caseEvidence (hypotheses, fits, 1);
%! assert (other.logE(1:3), evidence.logE(1:3), 0.25);

% SPDX-License-Identifier: GPL-3.0-only
