% LISTHYPOTHESES  Lists all hypotheses for one data set, by Laplace's formula.
%
% CALL: LIST = listHypotheses (MODELS, FITS, I, W)
%
%   MODELS, FITS  of makeHypotheses, fitLibrary;  I  row of the data set
%   W             struct gate, screen: of omnibusTest, screenEffects
%   LIST          1 x H struct h (newHypothesis), white, z (the data in its
%                 coordinates), modes (struct U, A), logPrior, logE (Laplace),
%                 and blank fields for what caseEvidence finds: error, ess, phi,
%                 atLimit, posterior
%
% Pairs, where there may be a gap: each of the two likeliest effects with the
% four whose signatures take most out of what it leaves. All pairs share the
% prior probability of pairs, also those that are not tried.
%
% See also: caseEvidence, fitLibrary

function list = listHypotheses (models, fits, i, w)
  white = models.white;
  K = numel (white.effect);
  weights = models.weights;
  z = fits.Z(i, :);
  list = entry (newHypothesis ('null'), white, z, fits.null, i, weights.null);
  for k = 1:K
    list(end + 1) = entry (newHypothesis ('single', k), white, z, ...
                           fits.single{k}, i, weights.single / K);
  end
  if K > 1 && w.gate.p < 2 * models.options.level
    list = [list, pairsOf(models, fits, i, list, w.screen)];
  end
  for k = 1:K
    list(end + 1) = entry (newHypothesis ('sibling', k), white, z, ...
                           fits.sibling{k}, i, weights.sibling / K);
  end
  for m = 1:numel (models.kinds)
    kind = models.kinds(m);
    list(end + 1) = entry (kind.h, kind.white, fits.rotated{m}(i, :), ...
                           fits.kind{m}, i, weights.discrepancy * kind.weight);
  end
end

function one = entry (h, white, z, fit, i, prior)
  one = struct ('h', h, 'white', white, 'z', z, 'modes', modesOf (fit, i), ...
                'logPrior', log (prior), 'logE', fit.logSum(i), ...
                'error', NaN, 'ess', NaN, 'phi', NaN (1, 3), 'atLimit', 0, ...
                'posterior', struct ('Q', [], 'weight', [], ...
                                     'cautious', []));
end

function modes = modesOf (fit, i)
  d = columns (fit.U);
  modes = struct ('U', fit.U(i, :), 'A', reshape (fit.A(i, :, :), d, d));
  if fit.hasOther(i)
    modes(2) = struct ('U', fit.other.U(i, :), ...
                       'A', reshape (fit.other.A(i, :, :), d, d));
  end
end

function list = pairsOf (models, fits, i, singles, screen)
  K = numel (models.white.effect);
  list = singles(zeros (1, 0));
  [~, order] = sort (-[singles(2:end).logE]);
  pairs = zeros (0, 2);
  for k = order(1:min (2, K))
    others = partnersOf (models.white, fits, i, k, screen);
    pairs = [pairs; repmat(k, numel (others), 1), others(:)];
  end
  prior = models.weights.pair / (K * (K - 1) / 2);
  for pair = unique (sort (pairs, 2), 'rows')'
    fit = fitPair (models, fits, i, pair');
    list(end + 1) = entry (newHypothesis ('pair', pair'), models.white, ...
                           fits.Z(i, :), fit, 1, prior);
  end
end

% By what their signatures explain of the residual of effect K.
function others = partnersOf (white, fits, i, k, screen)
  M = predictGap (white, k, fits.single{k}.Q(i, :));
  rho = screen.parity.N' * (fits.Z(i, :) - M)';
  own = screen.U(:, k) / max (norm (screen.U(:, k)), realmin);
  rest = screen.U - own * (own' * screen.U);
  % what is left of a signature that is the same but for rounding says nothing
  least = max (1e-16 * sum (screen.U.^2, 1), realmin);
  gain = (rest' * rho).^2 ./ max (sum (rest.^2, 1), least)';
  gain(k) = -Inf;
  [~, order] = sort (-gain);
  others = order(1:min (4, numel (gain) - 1));
end

function fit = fitPair (models, fits, i, pair)
  U = pairStarts (models.white.p, fits.single{pair(1)}.U(i, :), ...
                  fits.single{pair(2)}.U(i, :));
  h = newHypothesis ('pair', pair);
  all = fitHypothesis (models.white, h, repmat (fits.Z(i, :), 3, 1), U, ...
                       models.prior);
  [~, best] = max (all.logE);
  fit = struct ('U', all.U(best, :), 'A', all.A(best, :, :), ...
                'logSum', all.logE(best), 'hasOther', false);
end

%!test
%! models = handMadeHypotheses ();
%! fits = fitLibrary (models, [1.5, 0.5, 2, 2]);
%! w.gate.p = 0.01;
%! w.screen = screenEffects (models.white, fits.calibrated.Q, fits.Z);
%! list = listHypotheses (models, fits, 1, w);
%! assert (sum (exp ([list.logPrior])), 1, 1e-12);
%! hypotheses = [list.h];
%! assert ({hypotheses.kind}, {'null', 'single', 'single', 'pair', ...
%!                             'sibling', 'sibling', 'discrepancy'});
