% FUZZLAB  Draws a random laboratory for the diagnosis, with its truth.
%
% CALL: LAB = fuzzLab (SEED)
%
%   SEED  integer
%   LAB   struct, all in units of its own (parameters in [0, 1], effects with
%         the limits 0 and 1, targets with spans near 1):
%     given   for newProblem;  data  X, E, Z, replicate;  options
%     evaluate  handle Z = f (X, E, replicate), mostly []
%     truth   text: what makes the gap, '' where there is none
%     broken  text: what is wrong with it, '' where a verdict is due
%
% 1 to 8 parameters, 1 to 200 targets, 0 to 12 effects of DEM or of the
% laboratory, straight or bent, some of them collinear; runs without a result,
% responses that nothing moves, targets that are the same, simulations without
% noise, curves, targets that are held out or not measured, stated and unstated
% uncertainties. Small ones are drawn oftener: they cost less. In a quarter the
% noise is small and the targets are many, for a name to be in reach.
%
% See also: fuzzView, fuzzDiagnoses

function lab = fuzzLab (seed)
  rand ('twister', seed);
  randn ('twister', seed);
  few = @(most) 1 + floor (most * rand ()^3);
  p = few (8);
  T = few (8);
  if rand () < 0.03
    T = 12 + few (188);
  end
  K = floor (3.5 * rand ());
  if rand () < 0.1
    K = few (12);
  end
  noise = (rand () > 0.15) * 0.2 * rand ()^2;
  isClear = rand () < 0.25;
  if isClear
    [p, T, K, noise] = deal (few (2), 6 + few (6), 1 + few (2), 0.02);
  end
  law = responseLaw (p, T, K);
  isLab = rand (1, K) < 0.25;
  given = givenOf (p, T, K, isLab, law);
  if isClear
    given.sd(:) = 0.03;
  end
  lab.data = planOf (p, K, isLab, law, noise);
  [given.value, lab.truth] = measured (given, law, p, T, K);
  [given, lab.data] = damaged (given, lab.data);
  lab.options = struct ('twins', 24, 'bootstrap', 24, ...
                        'points', 120, 'effective', 80, 'most', 1200, ...
                        'leastPoints', 40, 'trend', '', 'verifyRuns', 2);
  trends = {'affine', 'choose', 'constant'};
  lab.options.trend = trends{few(3)};
  lab.evaluate = [];
  if rand () < 0.05
    lab.options.maxNewRuns = 4 + few (16);
    lab.evaluate = @(X, E, r) runsOf (X, E, r, isLab, law, noise);
  end
  [lab.given, lab.data, lab.broken] = broken (given, lab.data);
end

function law = responseLaw (p, T, K)
  law.slope = randn (p, T);
  law.bent = 0.3 * randn (p, T);
  law.effect = 2 * randn (K, T) .* (rand (K, T) < 0.7);
  if K > 1 && rand () < 0.4
    law.effect(2, :) = law.effect(1, :) * (1 + rand ());   % collinear
  end
  law.bend = 3.^(randn (1, K) / 2);
  if rand () < 0.2
    still = ceil (rand () * T);
    law.slope(:, still) = 0;                               % nothing moves it
    law.bent(:, still) = 0;
    law.effect(:, still) = 0;
  end
end

function Z = meansOf (X, phi, law)
  Z = 5 + X * law.slope + (X - 0.5).^2 * law.bent + ...
      (sign (phi) .* abs (phi).^law.bend) * law.effect;
end

% Scatter that only depends on the run, however its numbers are written.
function Z = runsOf (X, E, replicate, isLab, law, noise)
  phi = zeros (rows (X), numel (isLab));
  phi(:, ~isLab) = E;
  key = round (1e6 * [X, E, replicate]) * (1:columns (X) + columns (E) + 1)';
  u = mod (sin (key * (1:columns (law.slope))) * 43758.5453, 1);
  Z = meansOf (X, phi, law) + noise * (u - 0.5) * sqrt (12);
end

function given = givenOf (p, T, K, isLab, law)
  given = struct ('limits', [zeros(1, p); ones(1, p)], 'sd', ...
                  0.02 + 0.2 * rand ()^2 * (1 + rand (1, T)), 'trials', 1);
  B = min (T, 1 + floor (4 * rand ()));
  given.bench = sort ([1:B, ceil(B * rand (1, T - B))]);
  given.effects = [];
  for k = 1:K
    e = struct ('name', sprintf ('effect%d', k), 'variables', ...
                {{sprintf('v%d', k)}}, 'neutral', 0, 'limits', [0; 1], ...
                'laboratory', isLab(k), 'offset', zeros (1, T), ...
                'matrix', zeros (T));
    if isLab(k)
      e.offset = law.effect(k, :);
      e.matrix = diag (0.1 * (rand (1, T) < 0.3));
      [e.variables, e.neutral, e.limits] = deal ({}, [], zeros (2, 0));
    end
    given.effects = [given.effects, e];
  end
end

function data = planOf (p, K, isLab, law, noise)
  data.X = rand (p + 4 + floor (rand () * 5 * p), p);
  phi = zeros (rows (data.X), K);
  for k = find (~isLab)
    n = floor (12 * rand ());
    data.X = [data.X; rand(n, p)];
    own = zeros (n, K);
    own(:, k) = 0.1 + 0.9 * rand (n, 1);
    phi = [phi; own];
  end
  n = rows (phi);
  data.E = phi(:, ~isLab);
  data.replicate = ones (n, 1);
  if rand () < 0.3
    data.X(2:3, :) = data.X([1, 1], :);
    data.replicate(2:3) = [2; 3];
  end
  data.Z = runsOf (data.X, data.E, data.replicate, isLab, law, noise);
end

function [value, truth] = measured (given, law, p, T, K)
  phi = zeros (1, K);
  truth = '';
  if K > 0 && rand () < 0.65
    k = ceil (rand () * K);
    phi(k) = 0.3 + 0.7 * rand ();
    truth = sprintf ('effect%d', k);
  end
  value = meansOf (0.1 + 0.8 * rand (1, p), phi, law) + ...
          given.sd .* randn (1, T);
  if rand () < 0.15
    value = value + 3 * randn (1, T) .* (rand (1, T) < 0.4);
    truth = 'unlisted';
  end
end

function [given, data] = damaged (given, data)
  T = numel (given.value);
  [n, ~] = size (data.Z);
  chance = @(p) rand () < p;
  if chance (0.2)
    data.Z(rand (n, T) < 0.05) = NaN;
  end
  if T > 1 && chance (0.2)
    data.Z(:, 2) = data.Z(:, 1);                           % the same twice
    given.value(2) = given.value(1);
  end
  if chance (0.1)
    data.Z(:, 1) = 3 * chance (0.5);
  end
  given = unusual (given, T, chance);
  isUsed = isfinite (given.value) & ~given.held;
  if ~any (isUsed)
    given.held = false (1, T);
    given.value(1) = data.Z(find (isfinite (data.Z(:, 1)), 1), 1);
  end
end

function given = unusual (given, T, chance)
  given.held = false (1, T);
  if T > 2 && chance (0.3)
    given.value(rand (1, T) < 0.2) = NaN;
    given.held = rand (1, T) < 0.2;
  end
  if T > 3 && chance (0.3)
    given.series = double (given.bench == given.bench(1));
    given.coordinate = cumsum (rand (1, T));
    given.estimateSeries = given.series > 0 & chance (0.7);
  end
  if chance (0.15)
    given.sdKnown = rand (1, T) < 0.5;
  end
  if chance (0.15)
    given.sd(rand (1, T) < 0.5) = 0;
  end
  if chance (0.2)
    given.trials = Inf;
  end
  if chance (0.2)
    p = columns (given.limits);
    given.paramMean = NaN (1, p);
    given.paramSd = NaN (1, p);
    given.paramMean(1) = rand ();
    given.paramSd(1) = 0.05 + rand ();
  end
end

% What no diagnosis can be made of, and must be said.
function [given, data, what] = broken (given, data)
  what = '';
  if rand () > 0.08
    return
  end
  kinds = {'Inf', 'few', 'names', 'reserved', 'target', 'NaN parameter'};
  if numel (given.effects) < 2
    kinds([3, 4]) = [];
  end
  what = kinds{ceil(rand () * numel (kinds))};
  switch what
    case 'Inf'
      data.Z(2, 1) = Inf;
    case 'few'
      for name = {'X', 'E', 'Z', 'replicate'}
        data.(name{1}) = data.(name{1})(1:2, :);
      end
    case 'names'
      given.effects(2).name = given.effects(1).name;
    case 'reserved'
      words = {'null', 'unlisted'};
      given.effects(1).name = words{1 + (rand () < 0.5)};
    case 'target'
      data.Z(:, 1) = NaN;
      data.Z(1, 1) = 1;
    case 'NaN parameter'
      data.X(1, 1) = NaN;
  end
end

% SPDX-License-Identifier: GPL-3.0-only
