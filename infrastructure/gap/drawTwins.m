% DRAWTWINS  Draws data sets with a known cause from the surrogates themselves.
%
% CALL: TWINS = drawTwins (MODELS, CAUSES, D)
%
%   MODELS  struct of makeModels
%   CAUSES  1 x n cell of effect numbers ([]: no gap)
%   D       n x 1, signal to noise wanted for the (first) effect; limited by the
%           strongest plausible effect
%   TWINS   struct Y (n x T', values of the targets), theta (n x p, in [-1, 1]),
%           phi (n x 2, strengths), d (n x 1, signal to noise reached)
%
% Draws from the current random state.
%
% See also: calibrateVerdict

function twins = drawTwins (models, causes, d)
  white = models.white;
  n = numel (causes);
  T = columns (white.coef);
  twins = struct ('Y', zeros (n, T), 'theta', 1.9 * rand(n, white.p) - 0.95, ...
                  'phi', zeros (n, 2), 'd', zeros (n, 1));
  measured = find (models.prior.precision > 0);
  for j = measured
    value = models.prior.mean(j) + ...
            randn (n, 1) / sqrt (models.prior.precision(j));
    twins.theta(:, j) = min (max (value, -1), 1);
  end
  for i = 1:n
    h = causes{i};
    theta = twins.theta(i, :);
    if ~isempty (h)
      screen = screenEffects (white, theta, zeros (1, T));
      twins.phi(i, 1:numel (h)) = strengths (white, h, d(i), screen.size);
      twins.d(i) = abs (twins.phi(i, 1)) * screen.size(h(1));
    end
    [M, V] = predictGap (white, h, [theta, twins.phi(i, 1:numel (h))]);
    twins.Y(i, :) = M + sqrt (V) .* randn (1, T);
  end
  twins.Y = twins.Y / white.W';
end

function phi = strengths (white, h, d, sizes)
  phi = zeros (1, numel (h));
  for j = 1:numel (h)
    range = white.effect(h(j)).range;
    phi(j) = min (d / max (sizes(h(j)), eps), range(2));
    if range(1) < 0 && rand () < 0.5
      phi(j) = phi(j) / range(2) * range(1);
    end
  end
end
