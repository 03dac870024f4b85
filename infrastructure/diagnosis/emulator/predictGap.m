% PREDICTGAP  Predicts results and variances under a hypothesis, with slopes.
%
% CALL: [M, V, S, J] = predictGap (WHITE, H, Q)
%
%   WHITE  struct of whitenEmulator, or of fitEmulator if only M is asked for
%   H      1 x h, numbers of the active effects ([]: null model)
%   Q      n x (p + h), parameters in [-1, 1] and strengths of the effects
%   M      n x T, mean: the null model, what each effect adds, and what pairs of
%          them do together
%   V      n x T, variance: noise, baseline surrogate and effect surrogates
%   S      n x T, what the effects add to the null model
%   J      1 x (p + h) cell of n x T, slopes of M along Q
%
% Effects are polynomials in the bent strength psi = sign (phi) |phi|^bend, see
% fitEffect.

function [M, V, S, J] = predictGap (white, h, Q)
  p = white.p;
  theta = Q(:, 1:p);
  isSteep = nargout > 3;
  % slopes are polynomials of the same monomials: one product gives mean and slopes
  coefs = slopeCoefs (white.powers, white.coef, 1:p * isSteep);
  J = timesCoefs (polyRows (white.powers, theta), [{white.coef}, coefs]);
  base = J{1};
  J = J(2:end);
  J(numel (J) + 1:isSteep * (p + numel (h))) = {0};
  V = [];
  if nargout > 1
    V = exp (polyRows (white.varPowers, theta) * white.varCoef);
  end
  added = struct ('S', zeros (size (base)), 'V', V, 'J', {J});
  [psi, slope] = bentStrengths (white, h, Q(:, p + 1:end));
  for i = 1:numel (h)
    part = struct ('at', [1:p, p + i], 'e', white.effect(h(i)));
    added = addPart (part, [theta, psi], added);
  end
  for part = jointParts (white, h)
    added = addPart (part, [theta, psi], added);
  end
  S = added.S;
  V = added.V;
  J = added.J;
  for i = 1:isSteep * numel (h)
    J{p + i} = J{p + i} .* slope(:, i);
  end
  M = base + S;
end

% Where the strength is 0 a bend below 1 has no slope; a hundredth stands in.
function [psi, slope] = bentStrengths (white, h, phi)
  bend = ones (1, numel (h));
  for i = 1:numel (h)
    bend(i) = white.effect(h(i)).bend;
  end
  psi = bentStrength (phi, bend);
  slope = bend .* max (abs (phi), 0.01).^(bend - 1);
end

function parts = jointParts (white, h)
  parts = struct ('at', {}, 'e', {});
  if numel (h) ~= 2 || isempty (white.joint)
    return
  end
  pairs = vertcat (white.joint.members);
  % a pair is stored once, whichever of the two stands first here
  for order = [1, 2; 2, 1]'
    at = find (pairs(:, 1) == h(order(1)) & pairs(:, 2) == h(order(2)));
    if ~isempty (at)
      parts = struct ('at', [1:white.p, white.p + order'], ...
                      'e', white.joint(at));
    end
  end
end

% Every monomial of an effect holds its strength: the product of the strengths
% comes last, and where they are 0 their slopes need no division.
function added = addPart (part, whole, added)
  e = part.e;
  m = numel (e.bend);
  q = whole(:, part.at);
  p = columns (q) - m;
  psi = q(:, p + 1:end);
  powers = e.powers;
  powers(:, p + 1:end) = powers(:, p + 1:end) - 1;
  coefs = {e.coef};
  if ~isempty (added.J)
    coefs = [coefs, slopeCoefs(powers, e.coef, 1:p)];
    for i = 1:m
      coefs{end + 1} = e.powers(:, p + i) .* e.coef;
    end
  end
  B = polyRows (powers, q);
  parts = timesCoefs (B, coefs);
  strength = prod (psi, 2);
  added.S = added.S + strength .* parts{1};
  if ~isempty (added.V)
    added.V = added.V + strength.^2 .* effectVariance (e, B, 1);
  end
  for j = 1:numel (parts) - 1
    factor = strength;
    if j > p
      factor = prod (psi(:, [1:j - p - 1, j - p + 1:m]), 2);
    end
    added.J{part.at(j)} = added.J{part.at(j)} + factor .* parts{1 + j};
  end
end

% Coefficients of the derivative along each of VARIABLES, in the same
% monomials: a set that holds every monomial of one power less.
function coefs = slopeCoefs (powers, coef, variables)
  [q, d] = size (powers);
  place = (max ([powers(:); 0]) + 1).^(0:d - 1)';
  code = powers * place + 1;
  at = zeros (1, max ([code; 1]));
  at(code) = 1:q;
  coefs = cell (1, numel (variables));
  for j = variables
    has = powers(:, j) > 0;
    coefs{j} = zeros (size (coef));
    coefs{j}(at(code(has) - place(j)), :) = powers(has, j) .* coef(has, :);
  end
end

% Several polynomials of the same monomials B at once.
function parts = timesCoefs (B, coefs)
  T = columns (coefs{1});
  R = B * [coefs{:}];
  parts = cell (1, numel (coefs));
  for i = 1:numel (parts)
    parts{i} = R(:, (i - 1) * T + (1:T));
  end
end

%!test
%! white = handMadeHypotheses ().white;
%! [M, V, S, J] = predictGap (white, [1, 2], [0.5, 0.25, 1]);
%! assert (M, [1.5, 0.5, 1, -3]);
%! assert (V, ones (1, 4));
%! assert (J{1}, [3, 1, 0, 0]);
%! assert (J{3}, [0, 0, 0, -4]);
%! assert (S, [0, 0, 1, -3]);
%!test
%! % an effect that bends, and what a pair does together: slopes against
%! % differences
%! white = handMadeHypotheses ().white;
%! white.effect(1).bend = 0.5;
%! white.joint = struct ('members', [1, 2], 'powers', [0, 1, 1; 1, 1, 1], ...
%!                       'coef', [1, 0, 2, 0; 0, 3, 0, 0], 'bend', [1, 1], ...
%!                       'misfit', 4 * ones (1, 4), 'root', zeros (2, 0), ...
%!                       'ofTarget', zeros (0, 4), 'laboratory', false);
%! q = [0.5, 0.25, 0.7];
%! [M, V, ~, J] = predictGap (white, [1, 2], q);
%! assert (M, [1.5 + 0.35, 0.5 + 1.5 * 0.35, 2 + 0.7, 2 - 2.8], 1e-12);
%! assert (V, 1 + 4 * 0.35^2 * ones (1, 4), 1e-12);
%! for j = 1:3
%!   step = 1e-6 * ((1:3) == j);
%!   change = predictGap (white, [1, 2], q + step) - ...
%!            predictGap (white, [1, 2], q - step);
%!   assert (J{j}, change / 2e-6, 1e-7);
%! end
%! % the other order of the members is the same pair
%! assert (predictGap (white, [2, 1], q([1, 3, 2])), M, 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
