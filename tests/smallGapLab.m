% SMALLGAPLAB  A small linear laboratory for flows of the gap diagnosis.
%
% CALL: [GIVEN, DATA, MEANS] = smallGapLab ()
%
%   GIVEN   struct for newProblem, value still NaN: 3 benches with 4 targets
%           each, 2 parameters, 4 effects of DEM (the first two look alike), 1
%           of the laboratory
%   DATA    struct X, E, Z, replicate: 14 neutral runs, 10 of each effect
%   MEANS   handle, noiseless results of parameters in [0, 1] and strengths
%
% See also: standInGap

function [given, data, means] = smallGapLab ()
  rand ('twister', 9);
  randn ('twister', 9);
  S = 3 * randn (2, 12);
  F = 4 * randn (4, 12);
  F(2, :) = F(1, :) + 0.25 * randn (1, 12);
  G = 2 * [ones(1, 4), zeros(1, 8)];
  means = @(X, phi) 20 + (2 * X - 1) * S + phi(:, 1:4) * F + phi(:, 5) * G;
  names = {'cohesion', 'bridge', 'spread', 'size'};
  for k = 1:4
    effects(k) = struct ('name', names{k}, 'variables', {names(k)}, ...
                         'neutral', 0, 'limits', [0.1; 1], ...
                         'laboratory', false, 'offset', []);
  end
  effects(5) = struct ('name', 'bias', 'variables', {{}}, 'neutral', [], ...
                       'limits', zeros (2, 0), 'laboratory', true, ...
                       'offset', G);
  given = struct ('value', NaN (1, 12), 'sd', 0.2 * ones (1, 12), ...
                  'limits', [0, 0; 1, 1], 'bench', kron (1:3, ones (1, 4)));
  given.names = {'mu', 'rho'};
  given.effects = effects;
  data.X = [(1:14)' / 14 - 0.03, mod((1:14)' * 5, 14) / 14 + 0.02];
  phi = zeros (14, 5);
  for k = 1:4
    own = zeros (10, 5);
    own(:, k) = (1:10) / 10;
    data.X = [data.X; mod((1:10)' * 0.618, 1), mod((1:10)' * 0.755, 1)];
    phi = [phi; own];
  end
  data.E = phi(:, 1:4);
  data.Z = means (data.X, phi) + 0.2 * randn (rows (phi), 12);
  data.replicate = ones (rows (phi), 1);
end

% SPDX-License-Identifier: GPL-3.0-only
