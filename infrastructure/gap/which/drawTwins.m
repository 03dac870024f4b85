% DRAWTWINS  Draws data sets with a known cause from the surrogates themselves.
%
% CALL: TWINS = drawTwins (MODELS, CAUSES, D, SEED, SURPLUS)
%
%   MODELS  struct of makeHypotheses
%   CAUSES  1 x n cell of effect numbers ([]: no gap)
%   D       n x 1, signal to noise wanted for each effect of the cause; limited
%           by the strongest plausible effect
%   SEED    scalar; the random state is left as it was
%   SURPLUS scalar, factor on the variance (default 1)
%   TWINS   struct Y (n x T', values of the targets), theta (n x p, in [-1, 1]),
%           phi (n x 2, strengths), d (n x 1, signal to noise of the first)

function twins = drawTwins (models, causes, d, seed, surplus)
  if nargin < 5
    surplus = 1;
  end
  restore = seedRandom (seed);
  white = models.white;
  n = numel (causes);
  T = columns (white.coef);
  null = newHypothesis ('null');
  unknowns = viewHypothesis (white, null, models.prior).unknowns;
  twins = struct ('Y', zeros (n, T), 'phi', zeros (n, 2), 'd', zeros (n, 1));
  twins.theta = parametersOf (white, fromNormal (unknowns, randn (n, white.p)));
  M = zeros (n, T);
  V = zeros (n, T);
  isNull = cellfun (@isempty, causes);
  if any (isNull)
    [M(isNull, :), V(isNull, :)] = predictGap (white, [], ...
                                               twins.theta(isNull, :));
  end
  for i = find (~isNull(:)')
    h = causes{i};
    theta = twins.theta(i, :);
    own = setfield (white, 'effect', white.effect(h));
    reach = screenEffects (own, theta).size;
    phi = strengths (own.effect, d(i), reach);
    kinds = {'single', 'pair'};
    view = viewHypothesis (white, newHypothesis (kinds{numel(h)}, h), ...
                           models.prior);
    U = toNormal (view.unknowns, [theta, phi, randn()]);
    [M(i, :), V(i, :)] = predictHypothesis (view, U);
    twins.phi(i, 1:numel (h)) = phi;
    twins.d(i) = abs (phi(1)) * reach(1);
  end
  chi2 = 2 * randg (repmat (min (white.nu, 1e4) / 2, n, 1));
  noise = randn (n, T) ./ sqrt (chi2 ./ min (white.nu, 1e4));
  twins.Y = (M + sqrt (surplus * V) .* noise) * white.back';
end

% Where a reference has told of the parameters: Gaussian, cut at the box.
function theta = parametersOf (white, theta)
  [M, ~, ~, J] = predictGap (white, [], zeros (1, white.p));
  told = find (~white.isTarget);
  if isempty (told)
    return
  end
  J = reshape (vertcat (J{:})', columns (M), white.p)(told, :);
  A = J' * J + 0.5 * eye (white.p);
  middle = A \ (J' * -M(told)');
  theta = middle' + randn (size (theta)) / chol (A)';
  theta = min (max (theta, -1), 1);
end

function phi = strengths (effects, d, reach)
  phi = zeros (1, numel (effects));
  for j = 1:numel (effects)
    range = effects(j).range;
    phi(j) = min (d / max (reach(j), realmin), 1) * range(2);
    if range(1) < 0 && rand () < 0.5
      phi(j) = phi(j) / range(2) * range(1);
    end
  end
end

%!test
%! models = handMadeHypotheses ();
%! twins = drawTwins (models, {[], 1, [1, 2]}, [0; 2; 4], 1);
%! assert (size (twins.Y), [3, 4]);
%! assert (twins.phi(1, :), [0, 0]);
%! assert (twins.phi(2, 1), 2 / (4 * sqrt (2)), 1e-9);
%! assert (twins.d(2), 2, 1e-9);
%! assert (drawTwins (models, {[], 1, [1, 2]}, [0; 2; 4], 1).Y, twins.Y);
