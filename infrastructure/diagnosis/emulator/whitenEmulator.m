% WHITENEMULATOR  Turns an emulator into independent unit-variance coordinates.
%
% CALL: WHITE = whitenEmulator (EMULATOR, COLUMNS, NOISE, ROTATION)
%
%   EMULATOR  struct of fitEmulator
%   COLUMNS   1 x n, targets to look at
%   NOISE     struct of noiseBudget: covariance (T x T, of what a surrogate does
%             not cause), estimated and unknown (1 x T, parts of its diagonal
%             that runs have told, or nobody), doubt (2 x T)
%   ROTATION  n x n orthogonal, applied after whitening (default: none)
%   WHITE     struct like EMULATOR, results replaced by z = (y(COLUMNS)) * W', plus
%     W (n x n), back (its inverse), columns, varCoef (log variance of z without
%     effects), effect and joint with misfit, root and ofTarget of z
%     (learnEffect), nu (1 x n: degrees of freedom of the variances, Welch and
%     Satterthwaite), common (see logLikelihood: what few trials tell of their
%     scatter, as one scale of all), parity (n x m: the directions that parameters cannot
%     absorb, at the middle of the box), isTarget (1 x n: 1; see below)
%
% What a reference says of the parameters (EMULATOR.known, see emulateChange) comes as
% further coordinates: z = 0 measured, root theta - offset predicted, variance
% 1, moved by no effect. W and back are (n + m) x n and n x (n + m) then.
%
% W whitens NOISE plus the mean surrogate variance, so a variance of z without
% effects is near 1 and only its change over the box is modelled (quadratic in
% the logarithm, correlations of z neglected).

function white = whitenEmulator (emulator, targets, noise, rotation)
  n = numel (targets);
  along = emulator.misfitLikeness(targets, targets);
  misfit = sqrt (emulator.fitVar(targets));
  % what the polynomial misses is alike along a curve
  fixed = noise.covariance(targets, targets) + (misfit' * misfit) .* along;
  D = sqrt (emulator.surrogateVar(:, targets));
  C = emulator.correlation(targets, targets);
  meanD = sqrt (mean (D.^2, 1));
  [W, back] = whitener (fixed + (meanD' * meanD) .* C);
  if nargin > 3
    W = rotation * W;
    back = back * rotation';
  end
  white = struct ('p', emulator.p, 'powers', emulator.powers, 'W', W, 'back', back, ...
                  'columns', targets, 'varPowers', emulator.varPowers, ...
                  'success', emulator.success);
  other = setdiff (1:columns (emulator.success), emulator.bench(targets));
  % of benches that are not looked at nobody asks whether they gave a result
  white.success(:, other) = 0;
  white.coef = emulator.coef(:, targets) * W';
  V = zeros (rows (D), n);
  base = sum ((W * fixed) .* W, 2)';
  for i = 1:n
    V(:, i) = base(i) + alongRow (D, W(i, :), C);
  end
  % the logarithm keeps variances positive wherever the quadratic is taken
  white.varCoef = polyRows (emulator.varPowers, emulator.points) \ log (V);
  white.effect = arrayfun (@(e) oneEffect (e, targets, W, along), emulator.effect);
  white.joint = arrayfun (@(e) oneEffect (e, targets, W, along), emulator.joint);
  total = diag (fixed)' + meanD.^2;
  estimated = noise.estimated(targets) + meanD.^2;
  % Satterthwaite (1946): squares of the parts over their degrees of freedom
  doubt = estimated.^2 ./ emulator.noiseFreedom(targets) + ...
          noise.unknown(targets).^2 / 3 + noise.doubt(1, targets);
  white.nu = freedom (W, total, doubt);
  white.common = commonScale (W, total, noise.doubt(:, targets));
  white.isTarget = ones (1, n);
  if ~isempty (emulator.known)
    white = withKnown (white, emulator.known);
  end
  white.parity = parityAt (white, zeros (1, emulator.p));
end

function white = withKnown (white, known)
  m = rows (known.root);
  white.W = [white.W; zeros(m, columns (white.W))];
  white.back = [white.back, zeros(rows (white.back), m)];
  coef = zeros (rows (white.powers), m);
  coef(~any (white.powers, 2), :) = -known.offset';
  for j = 1:white.p
    coef(sum (white.powers, 2) == 1 & white.powers(:, j) == 1, :) = ...
      known.root(:, j)';
  end
  white.coef = [white.coef, coef];
  white.varCoef = [white.varCoef, zeros(rows (white.varCoef), m)];
  % as good as normal
  white.nu = [white.nu, repmat(1e6, 1, m)];
  white.isTarget = [white.isTarget, zeros(1, m)];
  white.common.at = white.isTarget > 0;
  white.common.stretch = [white.common.stretch, ones(1, m)];
  white.effect = arrayfun (@(e) withNone (e, m), white.effect);
  white.joint = arrayfun (@(e) withNone (e, m), white.joint);
end

function e = withNone (e, m)
  for name = {'coef', 'misfit', 'ofTarget'}
    e.(name{1}) = [e.(name{1}), zeros(rows (e.(name{1})), m)];
  end
end

% By the correlations: variances may differ by more than rounding allows.
function [W, back] = whitener (S)
  sd = sqrt (diag (S))';
  root = chol (S ./ (sd' * sd), 'lower');
  W = inv (root) ./ sd;
  back = sd' .* root;
end

% Variance of each row of deviations D along W(i, :), correlated by C.
function v = alongRow (D, w, C)
  weighted = D .* w;
  v = sum ((weighted * C) .* weighted, 2);
end

% Errors of an effect's signature are alike along a curve: of targets t and s
% with coefficients of covariance R_t^2 and R_s^2 that of both is C(t, s) R_t
% R_s. What makes less than a thousandth of a variance is left out.
function e = oneEffect (e, targets, W, C)
  [n, m] = deal (rows (W), numel (targets));
  e.coef = e.coef(:, targets) * W';
  D = sqrt (e.misfit(targets));
  e.misfit = zeros (1, n);
  for i = 1:n
    e.misfit(i) = alongRow (D, W(i, :), C);
  end
  if isempty (e.root)
    e.ofTarget = zeros (0, n);
    return
  end
  q = rows (e.root);
  R = reshape (e.root, q^2, [])(:, targets);
  % neighbours on a curve may be alike to the last digit
  F = chol (C + 1e-9 * eye (m), 'lower');
  [e.root, e.ofTarget] = deal (zeros (q, 0), zeros (0, n));
  for i = 1:n
    part = reshape (R * (W(i, :)' .* F), q, q * m);
    [U, D] = eig (part * part');
    [d, order] = sort (diag (D), 'descend');
    many = find (cumsum (d) >= 0.999 * sum (d), 1);
    e.root = [e.root, U(:, order(1:many)) .* sqrt(max (d(1:many)', 0))];
    e.ofTarget(end + (1:many), i) = 1;
  end
end

% A noise of which only a guess is known counts as estimated from four trials.
function nu = freedom (W, total, doubt)
  part = (W.^2) * total';
  nu = max (part.^2 ./ max ((W.^4) * doubt', realmin), 1)';
end

% The harmonic mean: what is known least decides. Variances are squares of 68 %
% half-widths.
function common = commonScale (W, total, doubt)
  part = (W.^2) * total';
  each = ((W.^4) * doubt') ./ part.^2;
  nu = max (1 / mean (each(:, 2)), 1);
  if nu > 1e4
    nu = Inf;
  end
  both = max (1 ./ sum (each, 2)', 1);
  both(both > 1e4) = Inf;
  common = struct ('freedom', nu, 'stretch', studentFactor (both).^2, 'at', ...
                   true (1, rows (W)));
end

function N = parityAt (white, theta)
  [~, V, ~, J] = predictGap (white, [], theta);
  slopes = reshape (vertcat (J{:})', numel (V), white.p) ./ sqrt (V');
  N = parityProjection (slopes, zeros (numel (V), 1)).N;
end

%!test
%! % two correlated targets become independent ones of unit variance
%! emulator = handMadeEmulator ([1, 2; 1, 0]);
%! emulator.noiseFreedom = [8, 8];
%! noise = struct ('covariance', [4, 1; 1, 1], 'estimated', [0, 0], ...
%!                'unknown', [0, 0], 'doubt', zeros (2));
%! white = whitenEmulator (emulator, 1:2, noise);
%! assert (white.W * noise.covariance * white.W', eye (2), 1e-12);
%! [M, V] = predictGap (white, [], 0.5);
%! assert (M, [1.5, 2] * white.W', 1e-12);
%! assert (V, [1, 1], 1e-9);
%! assert (all (white.nu > 1e4));
%! assert (size (white.parity), [2, 1]);
%! % a variance of which all, or half, was estimated with 8 degrees of freedom
%! noise = struct ('covariance', diag ([4, 4]), 'estimated', [4, 2], ...
%!                'unknown', [0, 0], 'doubt', zeros (2));
%! white = whitenEmulator (emulator, 1:2, noise);
%! assert (white.nu, [8, 32], 1e-9);
%! % a measurement uncertainty that nobody has stated
%! noise.unknown = [0, 4];
%! assert (whitenEmulator (emulator, 1:2, noise).nu(2) < 3.01);
%! % a half of one variance that four freedoms tell
%! assert (white.common.freedom, Inf);
%! noise.doubt = [0, 0; 4 / 4, 0];
%! white = whitenEmulator (emulator, 1:2, noise);
%! assert (white.common.freedom, 32, 1e-9);
%! assert (white.common.stretch, studentFactor ([16, Inf]).^2, 1e-9);
%!test
%! % variance of an effect: what the coefficients of two targets of one curve
%! % make of it, by hand
%! emulator = handMadeEmulator ([1, 2; 1, 0]);
%! emulator.noiseFreedom = [8, 8];
%! emulator.misfitLikeness = [1, 0.8; 0.8, 1];
%! R = {[2, 1; 1, 3], [1, 0; 0, 0.5]};
%! emulator.effect = struct ('powers', [0, 1; 1, 1], 'coef', [1, 2; 3, 4], 'bend', ...
%!                     1, 'misfit', [0.3, 0.1], 'root', [R{:}], ...
%!                     'ofTarget', kron (eye (2), [1; 1]));
%! noise = struct ('covariance', [4, 1; 1, 1], 'estimated', [0, 0], ...
%!                'unknown', [0, 0], 'doubt', zeros (2));
%! white = whitenEmulator (emulator, 1:2, noise);
%! [~, V] = predictGap (white, 1, [0.5, 0.6]);
%! [~, V0] = predictGap (white, [], 0.5);
%! b = 0.6 * [1, 0.5];
%! D = sqrt (emulator.effect.misfit);
%! for t = 2:-1:1
%!   for s = 2:-1:1
%!     K(t, s) = emulator.misfitLikeness(t, s) * (b * R{t} * R{s} * b' + ...
%!                                      0.36 * D(t) * D(s));
%!   end
%! end
%! assert (V - V0, diag (white.W * K * white.W')', 1e-3 * (V - V0));

% SPDX-License-Identifier: GPL-3.0-only
