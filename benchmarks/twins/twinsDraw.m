% TWINSDRAW  Draws the cases of a twin study with their truth.
%
% CALL: TWINS = twinsDraw (LABS, PERLAB, MIX)
%
%   LABS    of foreignTwins
%   PERLAB  scalar, cases of each laboratory
%   MIX     of twinsMix: which cases, and their random numbers
%   TWINS   1 x n struct: lab (number), class, cause (1 x c, effect numbers; 0 =
%           a cause that no list holds), removed (effect taken off the list, 0 =
%           none), phi (1 x K), theta (1 x p, in [0, 1]), d (signal to noise of
%           the cause), dEach (1 x c, of each cause alone), like (effect that a
%           look-alike resembles, 0 = none), cosine (of the two, NaN), alien (1
%           x T, signature that no list holds), y (1 x T)
%
% d: norm of the signature that the parameters cannot absorb, in units of the
% whole noise of the diagnosis: measurement, packing, surrogate.
% Classes: null; single; pair; off, a listed effect that is then taken off the
% list; look, an undeclared look-alike: the signature of a listed effect in the
% whitened space without what parameters absorb, turned into a random direction
% until the cosine is MIX.cosines. Parameters anywhere in the box, in every
% fifth case one of them within 5 % of a limit. Noise as measured there.
%
% See also: foreignTwins, twinsDiagnose

function twins = twinsDraw (labs, perLab, mix)
  rand ('twister', mix.seed);
  randn ('twister', mix.seed);
  twins = struct ('lab', {}, 'class', {}, 'cause', {}, 'removed', {}, ...
                  'phi', {}, 'theta', {}, 'd', {}, 'dEach', {}, ...
                  'like', {}, 'cosine', {}, 'alien', {}, 'y', {});
  for l = 1:numel (labs)
    classes = classesOf (perLab, mix);
    for i = 1:perLab
      twins(end + 1) = oneTwin (labs(l), l, classes{i}, i, mix);
    end
  end
end

function classes = classesOf (n, mix)
  counts = round (n * mix.shares);
  counts(end + 1) = n - sum (counts);
  classes = {};
  for k = 1:numel (counts)
    classes = [classes, repmat(mix.classes(k), 1, counts(k))];
  end
end

function twin = oneTwin (lab, number, class, i, mix)
  K = numel (lab.problem.effects);
  twin = struct ('lab', number, 'class', class, 'cause', [], ...
                 'removed', 0, 'phi', zeros (1, K), 'theta', [], 'd', 0, ...
                 'dEach', [], 'like', 0, 'cosine', NaN, ...
                 'alien', zeros (size (lab.noiseSd)));
  twin.theta = parametersOf (columns (lab.problem.limits));
  order = randperm (K);
  space = twinsSpace (lab, twin.theta);
  levels = mix.levels.(class);
  level = levels(1 + mod (i, numel (levels)));
  if any (strcmp (class, {'pair', 'off', 'look'}))
    order = reachableFirst (lab, space, order, level);
  end
  twin = giveCause (twin, order);
  if strcmp (class, 'look')
    twin.like = order(1);
    twin.cosine = mix.cosines(1 + mod (i, numel (mix.cosines)));
    twin = lookAlike (twin, lab, space, level);
  end
  for k = twin.cause(twin.cause > 0)
    if strcmp (class, 'pair')
      level = levels(randi (numel (levels)));
    end
    twin.phi(k) = twinsStrength (lab, space, k, level);
    alone = lab.means (twin.theta, twin.phi .* ((1:K) == k)) - space.base;
    twin.dEach(end + 1) = space.visible (alone);
  end
  shape = lab.means (twin.theta, twin.phi) - space.base + twin.alien;
  twin.d = space.visible (shape);
  twin.y = lab.measure (twin.theta, twin.phi) + twin.alien;
end

function theta = parametersOf (p)
  theta = rand (1, p);
  if rand () < 0.2
    theta(randi (p)) = 0.05 * rand ();
  end
end

function twin = giveCause (twin, order)
  switch twin.class
    case 'single'
      twin.cause = order(1);
    case 'pair'
      twin.cause = sort (order(1:2));
    case 'off'
      twin.cause = order(1);
      twin.removed = order(1);
    case 'look'
      twin.cause = 0;
  end
end

% Effects that reach the level at full strength, whichever way, come first.
function order = reachableFirst (lab, space, order, level)
  K = numel (order);
  here = ones (K, 1) * space.theta;
  reach = space.visible (lab.means (here, eye (K)) - space.base);
  back = space.visible (lab.means (here, -diag(lab.isSigned)) - space.base);
  reach(lab.isSigned) = min (reach, back)(lab.isSigned);
  [~, first] = sort (reach(order) < level);
  order = order(first);
end

% A cause whose visible signature has the cosine with that of the effect.
function twin = lookAlike (twin, lab, space, level)
  K = numel (lab.problem.effects);
  phi = twinsStrength (lab, space, twin.like, level) * ...
        ((1:K) == twin.like);
  shape = lab.means (twin.theta, phi) - space.base;
  u = space.free' * (space.factor \ shape');
  u = u / norm (u);
  v = randn (size (u));
  v = v - u * (u' * v);
  v = twin.cosine * u + sqrt (1 - twin.cosine^2) * v / norm (v);
  twin.alien = level * (space.factor * space.free * v)';
end

%!shared lab
%! lab = foreignLab (2);
%! lab.noise = sqrt (lab.noiseSd.^2 + lab.problem.sd.^2);
%!test % shares, seeds, levels that are reached or full strength
%! mix = twinsMix ('all');
%! twins = twinsDraw (lab, 40, mix);
%! assert (twinsDraw (lab, 40, mix), twins);
%! number = cellfun (@(c) sum (strcmp ({twins.class}, c)), mix.classes);
%! assert (number, [14, 12, 5, 3, 6]);
%! for t = twins(strcmp ({twins.class}, 'null'))
%!   assert ({t.cause, t.d, any(t.phi)}, {[], 0, false});
%! end
%! for t = twins(strcmp ({twins.class}, 'single'))
%!   assert (t.d, t.dEach, 1e-12);
%!   assert (sum (t.phi ~= 0), 1);
%! end
%! for t = twins(strcmp ({twins.class}, 'off'))
%!   assert (t.removed, t.cause);
%! end
%!test % look-alikes: cosine and signal to noise are as ordered
%! twins = twinsDraw (lab, 40, twinsMix ('all'));
%! for t = twins(strcmp ({twins.class}, 'look'))
%!   space = twinsSpace (lab, t.theta);
%!   K = numel (t.phi);
%!   w = @(s) space.free' * (space.factor \ s');
%!   cosines = zeros (2, 1);
%!   for side = 1:2
%!     full = lab.means (t.theta, (3 - 2 * side) * ((1:K) == t.like));
%!     near = w (full - space.base);
%!     cosines(side) = near' * w(t.alien) / norm (near) / norm (w (t.alien));
%!   end
%!   assert (min (abs (cosines - t.cosine)) < 0.1);
%!   assert (min (abs (t.d - [3, 5, 8, 12])) < 1e-9);
%!   assert (~any (t.phi));
%! end
%!test % single causes alone
%! twins = twinsDraw (lab, 7, twinsMix ('singles'));
%! assert (all (strcmp ({twins.class}, 'single')) && numel (twins) == 7);

% SPDX-License-Identifier: GPL-3.0-only
