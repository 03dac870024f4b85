% STANDIN  Cheap formulas in the place of a DEM model, with known truth.
%
% CALL: S = standIn (name)
%       S = standIn (name, seed)
%
% name  'plain': 5 parameters, 2 targets, the limits of the published example,
%       almost linear; 'noisy': the same with the scatter of the container
%       Lift100, 0.35 % and 3.3 %; 'rough': 6 parameters, 4 targets, with an
%       interaction, a plateau and a kink; and three in which friction
%       saturates, rolling friction counts by its root, and effects multiply:
%       'silo': 4 parameters, 3 targets of 2 models; 'shear': 3 parameters, 2
%       targets, 0.5 %; 'drum': 6 parameters, 4 targets of 2 models
%       or a name of bentStandIn: bends, jumps, peaks, decades, two outcomes
%       or of storedStandIn: stored runs of LIGGGHTS
% seed  integer: silo, shear and drum have another truth with each one, every
%       third within a tenth of the box of an edge in all parameters
% S     struct: name, names 1 x d, limits 2 x d, targetNames, value 1 x T,
%       response (handle, n x d -> n x T, no noise), noise (relative sd of a
%       run, scalar or 1 x T), model 1 x T
%
% The rough one has its targets at the inner set 0.55 0.5 0.6 0.4 0.5 0.5, in
% box widths. benchmarks/peers.py holds the formulas of the first three.
%
% See also: calibrateStandIn

function S = standIn (name, seed)
  if any (strcmp (name, {'exponential', 'threshold', 'peak', 'decades', 'ordered', ...
                         'clogging', 'cloggingTold'}))
    S = bentStandIn (name, seed);
    return
  end
  if any (strcmp (name, {'repose', 'hiddenEffect', 'drumAndBins'}))
    S = storedStandIn (name, seed);
    return
  end
  S.name = name;
  S.noise = 0.01;
  switch name
    case {'plain', 'noisy'}
      S.names = {'rho', 'mu_pp', 'mu_pw', 'mr_pp', 'mr_pw'};
      S.limits = [500, 0.3, 0.3, 0.025, 0.025; 800, 0.7, 0.7, 0.075, 0.075];
      S.targetNames = {'density', 'mass'};
      S.value = [400, 0.028];
      S.response = @plain;
      if strcmp (name, 'noisy')
        S.noise = [0.0035, 0.033];
      end
    case 'rough'
      S.names = {'a', 'b', 'c', 'd', 'e', 'f'};
      S.limits = [zeros(1, 6); ones(1, 6)];
      S.targetNames = {'angle', 'flow', 'mass', 'force'};
      S.response = @rough;
      S.value = rough ([0.55, 0.5, 0.6, 0.4, 0.5, 0.5]);
    case {'silo', 'shear', 'drum'}
      S = drawTruth (saturating (S), seed);
    otherwise
      error ('DEcalioc:standIn:unknownName', ...
             ['standIn: NAME must be plain, noisy, rough, silo, shear or ' ...
              'drum, got %s.'], name);
  end
  if ~isfield (S, 'model')
    S.model = ones (1, numel (S.value));
  end
end

function S = saturating (S)
  switch S.name
    case 'silo'
      S.names = {'rho', 'mu_pp', 'mr_pp', 'mu_pw'};
      S.limits = [1200, 0.1, 0.005, 0.1; 2600, 0.9, 0.25, 0.8];
      S.targetNames = {'density', 'rate', 'angle'};
      S.model = [1, 2, 2];
      S.response = @silo;
    case 'shear'
      S.names = {'mu_pp', 'mr_pp', 'bond'};
      S.limits = [0.1, 0.001, 0.1; 1, 0.3, 4];
      S.targetNames = {'stress', 'density'};
      S.model = [1, 1];
      S.noise = 0.005;
      S.response = @shear;
    case 'drum'
      S.names = {'rho', 'mu_pp', 'mu_pw', 'mr_pp', 'bond', 'e'};
      S.limits = [1000, 0.1, 0.1, 0.005, 0, 0.2; 3000, 0.9, 0.8, 0.3, 3, 0.9];
      S.targetNames = {'drumAngle', 'drumTorque', 'heapAngle', 'density'};
      S.model = [1, 1, 2, 2];
      S.response = @drum;
  end
end

function S = drawTruth (S, seed)
  rand ('twister', 1e6 + seed);
  u = rand (1, numel (S.names));
  if mod (seed, 3) == 0
    u = abs ((rand (size (u)) < 0.5) - 0.1 * u);
  end
  S.truth = S.limits(1, :) + u .* diff (S.limits);
  S.value = S.response (S.truth);
end

function Z = plain (P)
  Z = [P(:, 1) .* (0.62 - 0.06 * P(:, 2) - 0.25 * P(:, 4)), ...
       0.01 + 0.02 * P(:, 2) + 0.01 * P(:, 3) + 0.05 * P(:, 4) + ...
       0.01 * P(:, 5)];
end

function Z = rough (P)
  Z = [18 + 14 * P(:, 1) .* (0.4 + 0.6 * P(:, 2)) + 4 * P(:, 3), ...
       60 + 40 * tanh(4 * (P(:, 2) - 0.45)) - 15 * P(:, 4), ...
       3 + 5 * max(0, P(:, 3) - 0.35) + 2 * P(:, 1) .* P(:, 5), ...
       0.02 * exp(1.5 * P(:, 6)) .* (1 + 0.4 * P(:, 4))];
end

% Filling of a cylinder; flat-bottomed bin: rate by the law of Beverloo with a
% dead rim that grows with friction, slope of what stays in the bin.
function Z = silo (P)
  [rho, mu, mr, mw] = deal (P(:, 1), P(:, 2), P(:, 3), P(:, 4));
  bulk = rho .* (0.64 - 0.09 * mu ./ (mu + 0.3) - 0.12 * sqrt (mr));
  rim = 0.008 * (1 + 1.5 * tanh (1.5 * mu) + sqrt (mr));
  slope = 14 + 32 * mu ./ (mu + 0.35) .* (0.6 + 0.8 * sqrt (mr)) + ...
          6 * mw ./ (mw + 0.2);
  Z = [bulk, bulk .* sqrt(9.81) .* (0.06 - rim).^2.5, slope];
end

% Ring shear cell: stress at steady flow and density under the same load.
function Z = shear (P)
  [mu, mr, bond] = deal (P(:, 1), P(:, 2), P(:, 3));
  inner = 0.22 + 0.55 * mu ./ (mu + 0.4) + 0.3 * sqrt (mu .* mr);
  bulk = 1550 * (0.63 - 0.08 * tanh (2 * mu));
  Z = [5 * inner .* (1 + 0.15 * bond ./ (1 + 0.3 * bond)), ...
       bulk .* (1 - 0.1 * sqrt(bond) .* inner)];
end

% Rotating drum: slope (slip at the wall takes from it) and torque; poured heap:
% slope and density.
function Z = drum (P)
  [rho, mu, mw] = deal (P(:, 1), P(:, 2), P(:, 3));
  [mr, bond, e] = deal (P(:, 4), P(:, 5), P(:, 6));
  bulk = rho .* (0.63 - 0.1 * mu ./ (mu + 0.35) - 0.1 * sqrt (mr) - ...
                 0.03 * tanh (bond));
  grip = mw ./ (mw + 0.08);
  slope = 18 + grip .* (22 * tanh (1.6 * mu) .* (0.7 + 0.5 * sqrt (mr)) + ...
                        4 * bond ./ (bond + 1));
  Z = [slope, 0.002 * bulk .* sind(slope) .* (1 - 0.15 * e), ...
       13 + 28 * mu ./ (mu + 0.4) .* (0.5 + sqrt (mr)) + ...
       4 * sqrt(bond + 0.1) - 3 * e.^2, bulk];
end

%!test
%! S = standIn ('plain');
%! assert (S.response ([700, 0.5, 0.5, 0.05, 0.05]), ...
%!         [403.9583, 0.028], [0.7, 1e-9]);
%! S = standIn ('rough');
%! assert (S.value, [25.79, 61.895, 4.8, 0.049115], 1e-3);
%! assert (S.model, [1, 1, 1, 1]);

%!test  % inside the box, corners included; every parameter moves a response
%! for name = {'silo', 'shear', 'drum'}
%!   for seed = [1, 3]
%!     S = standIn (name{1}, seed);
%!     u = (S.truth - S.limits(1, :)) ./ diff (S.limits);
%!     assert (all (u >= 0 & u <= 1));
%!     assert (all (min (u, 1 - u) <= 0.1), seed == 3);
%!     assert (S.response (S.truth), S.value);
%!     step = 0.01 * diff (S.limits) .* (1 - 2 * (u > 0.5));
%!     P = S.truth + full (diag (step));
%!     moved = abs (S.response (P) ./ S.value - 1);
%!     assert (all (max (moved, [], 2) > 1e-4));
%!   end
%! end

% SPDX-License-Identifier: GPL-3.0-only
