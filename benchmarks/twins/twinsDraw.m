% TWINSDRAW  Draws the cases of the twin study with their truth.
%
% CALL: TWINS = twinsDraw (LABS, PERLAB, KIND)
%
%   LABS    of twinsLaboratories
%   PERLAB  scalar, cases of each laboratory
%   KIND    'blind' or 'develop': other random numbers
%   TWINS   1 x n struct: lab (number), class ('null', 'single', 'pair', 'out'),
%           cause (1 x c, effect numbers; 0 = a cause that no list holds),
%           removed (effect taken off the list, 0 = none), phi (1 x K), theta (1
%           x p, in [0, 1]), d (signal to noise of the cause), y (1 x T)
%
% d: norm of the signature that the parameters cannot absorb, in units of the
% whole noise of the diagnosis: measurement, packing, surrogate.
% Mix: 40 % without a gap, 35 % one effect at d = 1, 2, 3, 4, 6, 8, 10 % pairs,
% 15 % out of library: half of them a listed effect that is then taken off the
% list, half a signature that no effect has. Parameters anywhere in the box, in
% every fifth case one of them within 5 % of a limit. Measurement and packing
% noise are drawn from the laboratory, correlated by 0.2 within a bench.
%
% See also: twins, twinsDiagnose

function twins = twinsDraw (labs, perLab, kind)
  seed = 7001 + 1000 * strcmp (kind, 'develop') + 2000 * strcmp (kind, 'real');
  rand ('twister', seed);
  randn ('twister', seed);
  twins = struct ('lab', {}, 'class', {}, 'cause', {}, 'removed', {}, ...
                  'phi', {}, 'theta', {}, 'd', {}, 'y', {});
  levels = [1, 2, 3, 4, 6, 8];
  for l = 1:numel (labs)
    classes = classesOf (perLab);
    for i = 1:perLab
      level = levels(1 + mod (i, numel (levels)));
      twins(end + 1) = oneTwin (labs(l), l, classes{i}, level);
    end
  end
end

function classes = classesOf (n)
  counts = round (n * [0.4, 0.35, 0.1]);
  counts(4) = n - sum (counts);
  names = {'null', 'single', 'pair', 'out'};
  classes = {};
  for k = 1:4
    classes = [classes, repmat(names(k), 1, counts(k))];
  end
end

function twin = oneTwin (lab, number, kind, level)
  K = numel (lab.problem.effects);
  p = columns (lab.problem.limits);
  theta = rand (1, p);
  if rand () < 0.2
    theta(randi (p)) = 0.05 * rand ();
  end
  twin = struct ('lab', number, 'class', kind, 'cause', [], ...
                 'removed', 0, 'phi', zeros (1, K), 'theta', theta, 'd', 0);
  order = randperm (K);
  alien = zeros (size (lab.seedSd));
  switch kind
    case 'single'
      twin.cause = order(1);
    case 'pair'
      twin.cause = sort (order(1:2));
    case 'out'
      if rand () < 0.5
        twin.cause = order(1);
        twin.removed = order(1);
      else
        twin.cause = 0;
        alien = lab.direction(randi (2), :);
      end
  end
  noise = sqrt (lab.problem.sd.^2 + lab.seedSd.^2);
  for k = twin.cause(twin.cause > 0)
    twin.phi(k) = strengthFor (lab, theta, k, level, lab.noise);
  end
  shape = lab.means (theta, twin.phi) - lab.means (theta, zeros (1, K));
  if any (alien)
    alien = alien * level / visible (lab, theta, alien, lab.noise);
    shape = shape + alien;
  end
  twin.d = visible (lab, theta, shape, lab.noise);
  bench = lab.problem.bench;
  same = 0.2 * (bench' == bench) + 0.8 * eye (numel (bench));
  twin.y = lab.means (theta, zeros (1, K)) + shape + ...
           noise .* (randn (1, numel (noise)) * chol (same));
end

% Signal to noise of what the parameters cannot absorb.
function d = visible (lab, theta, shape, noise)
  p = numel (theta);
  J = zeros (numel (noise), p);
  K = numel (lab.problem.effects);
  for j = 1:p
    step = 0.02 * ((1:p) == j);
    J(:, j) = (lab.means (theta + step, zeros (1, K)) - ...
               lab.means (theta - step, zeros (1, K)))' / 0.04;
  end
  parity = parityProjection (J ./ noise', (shape ./ noise)');
  d = sqrt (parity.unabsorbed);
end

function phi = strengthFor (lab, theta, k, level, noise)
  K = numel (lab.problem.effects);
  base = lab.means (theta, zeros (1, K));
  side = 1;
  if lab.problem.effects(k).laboratory && rand () < 0.5
    side = -1;
  end
  grid = 0.02:0.02:1;
  phi = side;
  for g = grid
    shape = lab.means (theta, side * g * ((1:K) == k)) - base;
    if visible (lab, theta, shape, noise) >= level
      phi = side * g;
      return
    end
  end
end
