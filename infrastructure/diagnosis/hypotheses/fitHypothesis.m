% FITHYPOTHESIS  Fits the unknowns of a hypothesis to many data sets at once.
%
% CALL: FIT = fitHypothesis (WHITE, H, Z, U, PRIOR)
%
%   WHITE  struct of whitenEmulator
%   H      struct of newHypothesis
%   Z      n x T, whitened data sets, one a row
%   U      n x d, start of each, in normal coordinates (fromNormal)
%   PRIOR  struct mean, sd of the parameters, see viewHypothesis; with the field
%          flat = true parameters that nobody measured are not drawn to the
%          middle of the box (the calibrated set; logE means nothing then)
%   FIT    struct
%     U (n x d), Q (n x d: parameters in [-1, 1], strengths, size)
%     chi2 (n x 1): sum (r^2 / v)
%     A (n x d x d): expected curvature of minus log posterior density
%     logPeak (n x 1): log likelihood + log prior density at U, the latter
%       without its constant
%     logE (n x 1): log evidence by Laplace's formula
%
% Levenberg-Marquardt, vectorised over the rows. The prior is N (0, I), so that
%   logE = log likelihood (U) - U' U / 2 - log |A| / 2.
% Laplace's formula serves as a start and where thousands of data sets are
% compared alike; a verdict stands on integrateEvidence.

function fit = fitHypothesis (white, h, Z, U, prior)
  view = viewHypothesis (white, h, prior);
  view.pull = ones (1, columns (U));
  if isfield (prior, 'flat')
    % a trace of the prior: A stays regular where no target sees a parameter
    view.pull(isinf (view.unknowns.sd)) = 1e-4;
  end
  % far from the data Student's likelihood is flat: the normal one comes first
  view.nu = Inf (1, columns (Z));
  view.common = struct ('freedom', Inf, 'stretch', 1);
  at = climb (view, Z, U);
  [view.nu, view.common] = deal (white.nu, white.common);
  at = climb (view, Z, at.U);
  [~, logDet] = solveMany (at.A, at.g);
  % Laplace's formula; the 2 pi of the normal prior and of the integral cancel
  fit = struct ('U', at.U, 'Q', fromNormal (view.unknowns, at.U), ...
                'chi2', at.chi2, 'A', at.A, 'logPeak', at.score, ...
                'logE', at.score - 0.5 * logDet);
end

function at = climb (view, Z, U)
  n = rows (U);
  % Levenberg-Marquardt (Marquardt 1963, J. SIAM 11): a fifth after a step that gains,
  % ten times else
  damping = 0.01 * ones (n, 1);
  at = lookAt (view, Z, U);
  active = (1:n)';
  for iteration = 1:15
    if isempty (active)
      break
    end
    d = damping(active);
    U = at.U(active, :) + cutStep (damped (at.A(active, :, :), ...
                                           at.g(active, :), d));
    new = lookAt (view, Z(active, :), U);
    gain = new.score - at.score(active);
    better = gain > 0;
    at = replaced (at, active(better), new, better);
    d = d .* (0.2 * better + 10 * ~better);
    damping(active) = d;
    % ends where a step gains next to nothing (gapOptions: fitMargin), or none
    % does at any damping
    active = active((~better & d < 1e4) | gain > 0.002);
  end
end

function at = replaced (at, to, new, from)
  for field = {'U', 'score', 'chi2', 'g'}
    at.(field{1})(to, :) = new.(field{1})(from, :);
  end
  at.A(to, :, :) = new.A(from, :, :);
end

% Score (log likelihood + log prior), its gradient g and expected curvature A.
function at = lookAt (view, Z, U)
  [M, V, success, J, G] = predictHypothesis (view, U);
  [logL, chi2, weight] = logLikelihood (Z - M, V, view.nu, ...
                                        view.common);
  score = logL - 0.5 * sum (view.pull .* U.^2, 2) + success;
  at = struct ('U', U, 'score', score, 'chi2', chi2, 'g', -view.pull .* U);
  d = columns (U);
  slope = weight .* (Z - M) ./ V;
  at.A = zeros (rows (U), d, d);
  nu = min (view.nu, 1e4);
  % expected curvature of Student's likelihood against the normal one (Lange,
  % Little and Taylor 1989, J. Am. Stat. Assoc. 84); beyond 1e4 it is normal
  less = view.common.stretch .* (nu + 1) ./ (nu + 3);
  ofSpread = nu ./ (nu + 3);
  if isfinite (view.common.freedom)
    [less, ofSpread] = underScale (less, ofSpread, view.common);
  end
  slopes = zeros ([size(M), d]);
  for a = 1:d
    slopes(:, :, a) = J{a};
  end
  weighted = slopes .* (less ./ V);
  for a = 1:d
    at.g(:, a) = at.g(:, a) + sum (J{a} .* slope, 2);
    at.A(:, a, :) = sum (weighted(:, :, a) .* slopes, 2);
    at.A(:, a, a) = at.A(:, a, a) + view.pull(a);
  end
  if ~isempty (G)
    at = withVariance (at, G, weight .* (Z - M).^2 ./ V - 1, ofSpread);
  end
end

% The same of a scale that columns have in common.
function [less, ofSpread] = underScale (less, ofSpread, common)
  n = common.freedom + sum (common.at);
  at = common.at;
  less(at) = less(at) * n / (n + 2);
  ofSpread(at) = ofSpread(at) * (n - 1) / (n + 2);
end

% What the slopes G of the logarithm of the variances add.
function at = withVariance (at, G, excess, less)
  moved = find (~cellfun (@isempty, G));
  for a = moved
    at.g(:, a) = at.g(:, a) + 0.5 * sum (excess .* G{a}, 2);
    for b = moved
      at.A(:, a, b) = at.A(:, a, b) + 0.5 * sum (less .* G{a} .* G{b}, 2);
    end
  end
end

function step = damped (A, g, damping)
  for a = 1:columns (g)
    A(:, a, a) = A(:, a, a) .* (1 + damping) + damping;
  end
  step = solveMany (A, g);
end

function step = cutStep (step)
  % two deviations of the prior at most: farther the quadratic says nothing
  step = step ./ max (1, max (abs (step), [], 2) / 2);
end

% Many positive definite systems at once, A n x d x d, by Gaussian elimination
% without pivoting, and the logarithm of each determinant.
function [X, logDet] = solveMany (A, G)
  d = columns (G);
  % positive definite: elimination is stable without pivoting (Golub and Van Loan
  % 2013, 4.2)
  logDet = zeros (rows (G), 1);
  for k = 1:d
    logDet = logDet + log (A(:, k, k));
    below = k + 1:d;
    factor = A(:, below, k) ./ A(:, k, k);
    A(:, below, below) = A(:, below, below) - factor .* A(:, k, below);
    G(:, below) = G(:, below) - factor .* G(:, k);
  end
  X = zeros (size (G));
  for k = d:-1:1
    above = reshape (A(:, k, k + 1:d), rows (G), d - k);
    left = G(:, k) - sum (above .* X(:, k + 1:d), 2);
    X(:, k) = left ./ A(:, k, k);
  end
end

%!shared white, prior
%! white = handMadeHypotheses ().white;
%! prior = struct ('mean', 0, 'sd', Inf);
%!test
%! % the parameter is found, the evidence is close to the closed form: one
%! % direction of curvature 10 integrated over the box
%! fit = fitHypothesis (white, newHypothesis ('null'), [0.6, 0.2, 0, 0], 1, ...
%!                      prior);
%! assert (fit.Q, 0.2, 0.05);
%! exact = -2 * log (2 * pi) + 0.5 * log (2 * pi / 10) - log (2);
%! assert (fit.logE, exact, 0.15);   % Laplace's formula is not exact
%! prior.flat = true;
%! fit = fitHypothesis (white, newHypothesis ('null'), [0.6, 0.2, 0, 0], 1, ...
%!                      prior);
%! assert (fit.Q, 0.2, 1e-3);
%! fit = fitHypothesis (white, newHypothesis ('null'), [9, 3, 0, 0], 0, prior);
%! assert (fit.Q > 0.98 && fit.Q <= 1);
%!test
%! % several data sets at once give what each gives alone
%! h = newHypothesis ('single', 1);
%! Z = [1, 0.3, 3, 3; -2, -0.6, 1, 1];
%! both = fitHypothesis (white, h, Z, zeros (2, 4), prior);
%! for i = 1:2
%!   one = fitHypothesis (white, h, Z(i, :), zeros (1, 4), prior);
%!   assert (both.Q(i, :), one.Q, 1e-9);
%!   assert (both.logE(i), one.logE, 1e-9);
%! end
%!test
%! % beyond the box: the fit goes to the limit and stays finite
%! fit = fitHypothesis (white, newHypothesis ('null'), [9, 3, 0, 0], 0, prior);
%! assert (fit.Q > 0.9 && fit.Q <= 1);
%! assert (isfinite (fit.logE));
%!test
%! % the size of a discrepancy grows with the misfit
%! kind = handMadeHypotheses ().list(end);
%! for misfit = [1, 10]
%!   fit = fitHypothesis (kind.white, kind.h, [0, 0, misfit, -misfit], ...
%!                        [0, 0], prior);
%!   found(1 + (misfit > 1)) = fit.Q(2);
%! end
%! assert (found(2) > 3 * found(1));
%!test
%! % so it does for one result of one data set, as it does for two of them
%! one = handMadeHypotheses ().list(end);
%! for name = {'coef', 'varCoef', 'nu', 'shape', 'success'}
%!   one.white.(name{1}) = one.white.(name{1})(:, end);
%! end
%! one.white.common = struct ('freedom', Inf, 'stretch', 1, 'at', true);
%! fit = fitHypothesis (one.white, one.h, [9; 9], zeros (2, 2), prior);
%! assert (fitHypothesis (one.white, one.h, 9, [0, 0], prior).Q, fit.Q(1, :), ...
%!         1e-9);
%! assert (fit.Q(end) > 2 * one.h.extent(1));
%!test
%! % a start 30 deviations off finds the mass also where noise was estimated
%! steep = white;
%! steep.coef(2, :) = [60, 20, 30, 30];
%! steep.nu = [5, 5, 5, 5];
%! Z = repmat ([54, 18, 27, 27], 2, 1);
%! fit = fitHypothesis (steep, newHypothesis ('null'), Z, [-1; 2], prior);
%! assert (fit.Q, [0.9; 0.9], 0.01);

% SPDX-License-Identifier: GPL-3.0-only
