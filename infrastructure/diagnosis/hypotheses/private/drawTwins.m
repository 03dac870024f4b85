% DRAWTWINS  Draws data sets without a gap from the surrogates themselves.
%
% CALL: Y = drawTwins (HYPOTHESES, N, SEED, SURPLUS)
%
%   HYPOTHESES  struct of makeHypotheses
%   N        how many
%   SEED     scalar; the random state is left as it was
%   SURPLUS  scalar, factor on the variance (default 1)
%   Y        N x T', values of the targets

function Y = drawTwins (hypotheses, n, seed, surplus)
  if nargin < 4
    surplus = 1;
  end
  restore = seedRandom (seed);
  white = hypotheses.white;
  T = columns (white.coef);
  null = newHypothesis ('null');
  unknowns = viewHypothesis (white, null, hypotheses.prior).unknowns;
  theta = parametersOf (white, fromNormal (unknowns, randn (n, white.p)));
  [M, V] = predictGap (white, [], theta);
  noise = randn (n, T) .* errorFactors (white, n);
  Y = (M + sqrt (surplus * V) .* noise) * white.back';
end

% Where a reference has told of the parameters: Gaussian, cut at the box.
function theta = parametersOf (white, theta)
  [M, ~, ~, J] = predictGap (white, [], zeros (1, white.p));
  told = find (~white.isTarget);
  if isempty (told)
    return
  end
  J = reshape (vertcat (J{:})', columns (M), white.p)(told, :);
  % the box as a normal prior, its deviation sqrt (2), where the reference tells
  % little
  A = J' * J + 0.5 * eye (white.p);
  middle = A \ (J' * -M(told)');
  theta = middle' + randn (size (theta)) / chol (A)';
  theta = min (max (theta, -1), 1);
end

%!test
%! hypotheses = handMadeHypotheses ();
%! Y = drawTwins (hypotheses, 3, 1);
%! assert (size (Y), [3, 4]);
%! assert (drawTwins (hypotheses, 3, 1), Y);
%! % one scale of all: squares of targets that are independent else rise together
%! % (chance to fail below 0.1 %)
%! hypotheses.white.common = struct ('freedom', 3, 'stretch', ...
%!                                   studentFactor (3)^2 * ones (1, 4), 'at', true (1, 4));
%! Y = drawTwins (hypotheses, 2000, 1)(:, 3:4);
%! assert (corr (log (Y(:, 1).^2), log (Y(:, 2).^2)) > 0.08);
%! assert (mean (abs (Y(:)) < 1), 0.683, 0.03);

% SPDX-License-Identifier: GPL-3.0-only
