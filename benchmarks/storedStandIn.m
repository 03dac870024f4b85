% STOREDSTANDIN  A stand-in whose responses are those of stored LIGGGHTS runs.
%
% CALL: S = storedStandIn (NAME [, SEED])
%
%   NAME  store of runs: 'repose' (the template, 121 runs), 'hiddenEffect' or
%         'drumAndBins' (those without an effect, 35 and 51 sets)
%   SEED  integer (1), draws the truth in the middle 80 % of the box
%   S     struct, see standIn; tol 1 x T: as wide as one run scatters
%
% The mean of a response is the local straight fit to the nearest two fifths of the
% runs with tricube weights (Cleveland 1979, JASA 74), another smoother than the
% surrogates', so that these are not measured by themselves. A run scatters as the
% runs do about that fit without them, less what the fit itself scatters. What
% LIGGGHTS does between the runs, and scatter that is no normal one, are not in it.
%
% See also: standIn, floors, storedRepose, storedCampaign

function S = storedStandIn (name, seed)
  if nargin < 2
    seed = 1;
  end
  root = startBenchmarks ();
  if strcmp (name, 'repose')
    store = storedRepose (root);
    [problem, data] = deal (store.problem, store.data);
    isUsed = problem.calibrate;
    S.names = {'coefFrictionPP', 'coefRollingFrictionPP'};
  else
    [problem, data] = storedCampaign (name, root);
    isNeutral = all (abs (strengthOfValues (problem.effects, data.E)) < 1e-9, 2);
    data.X = data.X(isNeutral, :);
    data.Z = data.Z(isNeutral, :);
    wanted = {'bulkDensity', 'runOut', 'heightBack', 'collapseSlope', 'friction', ...
              'drumSlope1', 'drumSlope3', 'rate1', 'remaining1', 'binSlope1'};
    isUsed = ismember (problem.targetNames, wanted);
    S.names = {'densityP', 'coefFrictionPP', 'coefFrictionPW', 'coefRollingFrictionPP'};
  end
  known = all (isfinite (data.Z(:, isUsed)), 2);
  U = toUnit (data.X(known, :), problem.limits);
  Z = data.Z(known, isUsed);
  S.name = name;
  S.limits = problem.limits;
  S.targetNames = problem.targetNames(isUsed);
  S.model = problem.bench(isUsed);
  S.response = @(P) smoother (U, toUnit (P, problem.limits)) * Z;
  rand ('twister', 1e6 + seed);
  S.truth = fromUnit (0.1 + 0.8 * rand (1, columns (U)), problem.limits);
  S.value = S.response (S.truth);
  for i = 1:rows (U)
    others = [1:i - 1, i + 1:rows(U)];
    weights = smoother (U(others, :), U(i, :));
    off(i, :) = (Z(i, :) - weights * Z(others, :)) / sqrt (1 + sumsq (weights, 2));
  end
  S.noise = sqrt (mean (off.^2, 1)) ./ abs (mean (Z, 1));
  S.tol = S.noise;
end

% The weights (v x n) of the runs at U in the mean at V.
function M = smoother (U, V)
  [n, d] = size (U);
  k = max (ceil (0.4 * n), ceil (1.5 * (d + 1)));
  M = zeros (rows (V), n);
  for i = 1:rows (V)
    D = U - V(i, :);
    apart = sqrt (sumsq (D, 2));
    reach = 1.001 * sort (apart)(k);      % the k-th nearest still counts
    root = sqrt ((1 - min (apart / reach, 1).^3).^3);
    line = pinv (root .* [ones(n, 1), D]) .* root';
    M(i, :) = line(1, :);
  end
end

%!test
%! % the same numbers, whoever asks; a run scatters by a share of its response
%! S = storedStandIn ('repose', 3);
%! assert (S.value, storedStandIn ('repose', 3).response (S.truth));
%! assert (size (S.response (S.limits)), [2, numel(S.value)]);
%! assert (all (S.noise > 0.005 & S.noise < 0.2), num2str (S.noise));
%! assert (all (S.truth > S.limits(1, :) & S.truth < S.limits(2, :)));

% SPDX-License-Identifier: GPL-3.0-only
