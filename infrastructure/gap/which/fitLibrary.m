% FITLIBRARY  Fits the null model, each effect and each misfit to data sets.
%
% CALL: FITS = fitLibrary (MODELS, Y)
%
%   MODELS  struct of makeHypotheses
%   Y       n x T', data sets: values of the targets MODELS.white.columns
%   FITS    struct of fits as of fitHypothesis, best start of each row
%     Z        n x T', whitened Y
%     null     with other (the second best distinct mode, same fields) and
%              hasOther (n x 1 logical)
%     calibrated  the null model with a flat prior in the box: what a
%              calibration finds
%     single   1 x K cell, the same for each effect
%     sibling  1 x K cell, something that resembles it
%     kind     1 x m cell, each discrepancy;  rotated 1 x m cell, Y for it
%     logE     n x (1 + 2 K + m), Laplace evidences in this order
%
% See also: caseEvidence, fitHypothesis, omnibusReference

function fits = fitLibrary (models, Y)
  white = models.white;
  prior = models.prior;
  n = rows (Y);
  fits.Z = Y * white.W';
  null = newHypothesis ('null');
  starts = toNormal (unknownsOf (white, null, prior), models.starts);
  fits.null = bestOf (white, null, fits.Z, repmat (starts, n, 1), prior);
  flat = setfield (prior, 'flat', true);
  fits.calibrated = fitHypothesis (white, null, fits.Z, fits.null.U, flat);
  fits.logE = fits.null.logSum;
  K = numel (white.effect);
  fits.single = cell (1, K);
  fits.sibling = cell (1, K);
  for k = 1:K
    h = newHypothesis ('single', k);
    phi = startStrengths (white.effect(k).range);
    phi = toNormal (unknownsOf (white, h, prior), ...
                    [zeros(numel (phi), white.p), phi(:), ...
                     zeros(numel (phi), 1)])(:, white.p + [1, 2]);
    U = [kron(fits.null.U, ones (rows (phi), 1)), repmat(phi, n, 1)];
    fits.single{k} = bestOf (white, h, fits.Z, U, prior);
    fits.logE(:, end + 1) = fits.single{k}.logSum;
  end
  for k = 1:K
    fits.sibling{k} = bestOf (white, newHypothesis ('sibling', k), fits.Z, ...
                              [fits.single{k}.U, zeros(n, 1)], prior);
    % with no more measured values than parameters nothing is left to resemble
    fits.sibling{k}.logSum(isnan (fits.sibling{k}.logSum)) = -Inf;
    fits.logE(:, end + 1) = fits.sibling{k}.logSum;
  end
  for m = 1:numel (models.kinds)
    kind = models.kinds(m);
    fits.rotated{m} = Y * kind.white.W';
    fits.kind{m} = bestOf (kind.white, kind.h, fits.rotated{m}, ...
                           [fits.null.U, zeros(n, 1)], prior);
    fits.logE(:, end + 1) = fits.kind{m}.logSum;
  end
end

function phi = startStrengths (range)
  phi = [0.15, 0.6] * range(2);
  if range(1) < 0
    phi = [0.6 * range(1), 0.6 * range(2)];
  end
end

% The starts of one data set follow each other in U.
function best = bestOf (white, h, Z, U, prior)
  n = rows (Z);
  s = rows (U) / n;
  all = fitHypothesis (white, h, kron (Z, ones (s, 1)), U, prior);
  logE = reshape (all.logE, s, n);
  [first, which] = max (logE, [], 1);
  at = (0:n - 1) * s + which;
  best = pick (all, at);
  best.logSum = first';
  best.hasOther = false (n, 1);
  if s == 1
    return
  end
  far = sqrt (sum ((all.U - kron (best.U, ones (s, 1))).^2, 2)) > 0.5;
  logE(~reshape (far, s, n)) = -Inf;
  [second, which] = max (logE, [], 1);
  best.other = pick (all, (0:n - 1) * s + which);
  best.hasOther = (first - second)' < 4;
  best.logSum = best.logSum + best.hasOther .* log1p (exp (second - first)');
end

function part = pick (all, at)
  part = struct ('U', all.U(at, :), 'Q', all.Q(at, :), 'chi2', all.chi2(at), ...
                 'A', all.A(at, :, :), 'logE', all.logE(at));
end

%!test
%! models = handMadeHypotheses ();
%! fits = fitLibrary (models, [1.5, 0.5, 2, 2; 0, 0, 0, -2]);
%! assert (fits.calibrated.Q, [0.5; 0], 1e-3);
%! assert (fits.null.Q, [0.5; 0], 0.1);
%! assert (fits.single{1}.Q(1, 1:2), [0.5, 16 / 36], 0.1);
%! assert (fits.single{2}.Q(2, 1:2), [0, 8 / 20], 0.1);
%! assert (size (fits.kind{1}.Q), [2, 2]);
%! assert (size (fits.logE), [2, 6]);
%! % the right effect has the larger evidence, and its sibling less
%! assert (fits.logE(1, 2) > max (fits.logE(1, [1, 3:6])));
