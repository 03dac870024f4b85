% LISTHYPOTHESES  Lists all hypotheses for one data set, by Laplace's formula.
%
% CALL: LIST = listHypotheses (MODELS, FITS, I, W)
%
%   MODELS, FITS  of makeHypotheses, fitLibrary;  I  row of the data set
%   W             struct gate, screen: of omnibusTest, screenEffects
%   LIST          1 x H struct, the rows of MODELS.list and, behind the single
%                 effects, pairs: h (newHypothesis), white, z (the data in its
%                 coordinates), modes (struct U, A), logPrior, logE (Laplace),
%                 and blank fields for what caseEvidence finds: error, ess, phi
%                 (median strength of the first member), atLimit, posterior
%
% Pairs, where there may be a gap: each of the two likeliest effects with the
% four whose signatures take most out of what it leaves. All pairs share the
% prior probability of pairs, also those that are not tried.

function list = listHypotheses (models, fits, i, w)
  for j = numel (models.list):-1:1
    row = models.list(j);
    list(j) = entry (row.h, row.white, row.prior, fits.of{j}, i);
  end
  singles = models.singles;
  if numel (singles) > 1 && w.gate.p < 2 * models.options.level
    pairs = pairsOf (models, fits, i, w.screen);
    list = [list(1:singles(end)), pairs, list(singles(end) + 1:end)];
  end
end

function one = entry (h, white, prior, fit, i)
  one = struct ('h', h, 'white', white, 'z', fit.Z(i, :), ...
                'modes', modesOf (fit, i), ...
                'logPrior', log (prior), 'logE', fit.logSum(i), ...
                'error', NaN, 'ess', NaN, 'phi', NaN, 'atLimit', 0, ...
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

function list = pairsOf (models, fits, i, screen)
  singles = models.singles;
  [~, order] = sort (-fits.logE(i, singles));
  pairs = zeros (0, 2);
  for k = order(1:2)
    M = predictGap (models.white, k, fits.of{singles(k)}.Q(i, :));
    others = partnersOf (k, fits.Z(i, :) - M, screen);
    pairs = [pairs; repmat(k, numel (others), 1), others(:)];
  end
  pairs = unique (sort (pairs, 2), 'rows');
  for m = rows (pairs):-1:1
    fit = fitEffects (models, fits, i, pairs(m, :), models.prior);
    list(m) = entry (newHypothesis ('pair', pairs(m, :)), models.white, ...
                     models.pairPrior, fit, 1);
  end
end

% By what their signatures explain of the residual R of effect K.
function others = partnersOf (k, r, screen)
  rho = screen.parity.N' * r';
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
%! models = handMadeHypotheses ();
%! fits = fitLibrary (models, [1.5, 0.5, 2, 2]);
%! w.gate.p = 0.01;
%! w.screen = screenEffects (models.white, fits.calibrated.Q, fits.Z);
%! list = listHypotheses (models, fits, 1, w);
%! assert (sum (exp ([list.logPrior])), 1, 1e-12);
%! hypotheses = [list.h];
%! assert ({hypotheses.kind}, {'null', 'single', 'single', 'pair', ...
%!                             'sibling', 'sibling', 'discrepancy'});
