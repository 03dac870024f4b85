% WEIGHCASE  Computes the evidence of every hypothesis for one data set.
%
% CALL: W = weighCase (MODELS, FITS, I, WITHPAIRS)
%
%   MODELS     struct of makeModels
%   FITS       struct of fitLibrary
%   I          scalar, row of the data set
%   WITHPAIRS  logical, weigh pairs of the likeliest effects too
%   W          struct
%     logE, logPrior (1 x H), members (1 x H cell: effects of each hypothesis),
%     kind (1 x H cell: 'null', 'single', 'pair', 'unlisted')
%     fitP (1 x H, fit test at the mode), error, ess (1 x H)
%     phi (H x 3: median and 90 % interval of the first strength), atLimit (1 x
%     H, posterior mass glued to the end of the range of one of the strengths),
%     vague (1 x H, part of the variance at the mode that is the surrogate of
%     the effects)
%     gate (struct of gateTest), screen (struct of screenEffects)
%     posterior  1 x H cell: Q, weight (samples of each hypothesis)
%
% A sample whose effective size is below 15 % is drawn again around its own mean
% and covariance.
%
% See also: judgeCase, integrateEvidence

function w = weighCase (models, fits, i, withPairs)
  z = fits.Z(i, :);
  w.screen = screenEffects (models.white, fits.null.Q(i, :), z);
  w.gate = gateTest (models, w.screen, fits.null, i);
  K = numel (models.white.effect);
  list = oneHypothesis (models, [], z, modesOf (fits.null, i), 'null');
  for k = 1:K
    list(end + 1) = oneHypothesis (models, k, z, ...
                                   modesOf (fits.single{k}, i), 'single');
  end
  if withPairs && K > 1 && w.gate.p < models.level
    list = [list, pairsOf(models, fits, i, list(2:end))];
  end
  list(end + 1) = weighUnlisted (models, fits, i);
  w = collect (w, list, models, K);
end

function w = collect (w, list, models, K)
  fields = {'logE', 'fitP', 'error', 'ess', 'atLimit', 'vague'};
  for f = 1:numel (fields)
    w.(fields{f}) = [list.(fields{f})];
  end
  w.kind = {list.kind};
  w.members = {list.members};
  w.phi = vertcat (list.phi);
  w.posterior = arrayfun (@(h) h.posterior, list, 'UniformOutput', false);
  share = struct ('null', 1, 'single', max (K, 1), ...
                  'pair', max (K * (K - 1) / 2, 1), 'unlisted', 1);
  w.logPrior = cellfun (@(k) log (models.weights.(k) / share.(k)), w.kind);
end

function modes = modesOf (fit, i)
  modes = struct ('Q', fit.Q(i, :), 'A', squeeze (fit.A(i, :, :)), ...
                  'chi2', fit.chi2(i), 'cost', fit.cost(i));
  if fit.hasOther(i)
    other = struct ('hasOther', false, 'Q', fit.other.Q(i, :), ...
                    'A', fit.other.A(i, :, :), 'chi2', fit.other.chi2(i), ...
                    'cost', fit.other.cost(i));
    modes(2) = modesOf (other, 1);
  end
end

function h = oneHypothesis (models, members, z, modes, kind)
  box = hypothesisBox (models.white, members, models.prior);
  d = numel (box.lo);
  flat = diag (3 * (box.precision == 0) ./ ((box.hi - box.lo) / 2).^2);
  % targets fewer than parameters leave directions without any curvature
  free = trace (pinv (modes(1).A) * (modes(1).A - diag (box.precision)));
  for m = 1:numel (modes)
    modes(m).A = modes(m).A + flat;
  end
  r = integrateEvidence (models.white, members, z, modes, box, models.base);
  r = integrateAgain (r, models, members, z, box);
  h = struct ('kind', kind, 'members', members, 'logE', r.logE, ...
              'error', r.error, 'ess', r.ess, 'phi', NaN (1, 3), ...
              'atLimit', 0, 'vague', vagueShare (models, members, modes(1).Q));
  h.fitP = chiSquareTail (modes(1).chi2, max (numel (z) - free, 0.5));
  h.posterior = struct ('Q', r.Q, 'weight', r.weight);
  if ~isempty (members)
    at = models.white.p + (1:numel (members));
    h.phi = weightedQuantile (r.Q(:, at(1)), r.weight, [0.5, 0.05, 0.95]);
    lo = box.lo(at)(:)';
    hi = box.hi(at)(:)';
    margin = 0.02 * (hi - lo);
    ends = r.Q(:, at) > hi - margin | (lo < 0 & r.Q(:, at) < lo + margin);
    h.atLimit = max (r.weight(:)' * ends);
  end
end

% A poor sample shows where the mass is: the next one is drawn there.
function r = integrateAgain (r, models, members, z, box)
  for again = 1:2
    if r.ess > 0.15 * rows (models.base.normal) || r.ess < numel (box.lo) + 2
      return
    end
    middle = r.weight' * r.Q;
    D = (r.Q - middle) .* sqrt (r.weight);
    C = 1.2 * (D' * D) + diag (1e-6 * (box.hi - box.lo).^2);
    mode = struct ('Q', middle, 'A', inv ((C + C') / 2));
    new = integrateEvidence (models.white, members, z, mode, box, models.base);
    if new.ess > r.ess
      r = new;
    end
  end
end

% Part of the variance that comes from not knowing the effects well enough.
function share = vagueShare (models, members, Q)
  [~, V] = predictGap (models.white, members, Q);
  [~, V0] = predictGap (models.white, [], Q(1:models.white.p));
  share = mean ((V - V0) ./ V);
end

function list = pairsOf (models, fits, i, singles)
  [~, order] = sort (-[singles.logE]);
  pairs = nchoosek (order(1:min (4, numel (order))), 2);
  list = singles(zeros (1, 0));
  z = fits.Z(i, :);
  p = models.white.p;
  for j = 1:rows (pairs)
    k = pairs(j, 1);
    l = pairs(j, 2);
    a = fits.single{k}.Q(i, :);
    b = fits.single{l}.Q(i, :);
    Q = [a, 0.3; a, 0.05; b(1:p), 0.3, b(end); (a(1:p) + b(1:p)) / 2, ...
         a(end) / 2, b(end) / 2];
    box = hypothesisBox (models.white, [k, l], models.prior);
    fit = fitHypothesis (models.white, [k, l], repmat (z, rows (Q), 1), Q, box);
    [~, best] = min (fit.cost);
    mode = struct ('Q', fit.Q(best, :), 'chi2', fit.chi2(best), ...
                   'A', squeeze (fit.A(best, :, :)), 'cost', fit.cost(best));
    list(end + 1) = oneHypothesis (models, [k, l], z, mode, 'pair');
  end
end

%!test
%! % evidence of the null model against the closed form: three targets without
%! % parameter, one direction integrated over the box
%! models = handMadeModels ();
%! w = weighCase (models, fitLibrary (models, [1.5, 0.5, 0, 0]), 1, false);
%! exact = -2 * log (2 * pi) + 0.5 * log (2 * pi / 10) - log (2) ...
%!         + log (normalTail (-1.5 * sqrt (10)) - normalTail (sqrt (10) / 2));
%! assert (w.logE(1), exact, 0.1);
%! assert (w.kind, {'null', 'single', 'single', 'unlisted'});
%!test
%! % a strong signal along effect a: it wins, its strength is found
%! models = handMadeModels ();
%! w = weighCase (models, fitLibrary (models, [1.5, 0.5, 3, 3]), 1, true);
%! [~, best] = max (w.logPrior + w.logE);
%! assert (w.members{best}, 1);
%! assert (w.phi(best, 1), 0.7, 0.1);
%! assert (w.phi(best, 2) < 0.75 && 0.75 < w.phi(best, 3));
%! assert (any (strcmp (w.kind, 'pair')));
