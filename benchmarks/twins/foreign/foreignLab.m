% FOREIGNLAB  A laboratory of published laws that the diagnosis does not know.
%
% CALL: LAB = foreignLab (NUMBER)
%       LAB = foreignLab (NUMBER, CHANGE)
%
%   NUMBER  whole number from 1: four laws in turn (silo, drums, columns, benchtop),
%           their constants a little different each time
%   CHANGE  struct of values (as many as there are now) at which its benches are
%           set up otherwise: opening, speed, load ..., fields of c in lab*.m
%   LAB     struct
%     name      text
%     problem      as newProblem wants it, value still NaN
%     means     handle, Z = means (THETA, PHI): n x T results without noise;
%               THETA n x p in [0, 1], PHI n x K strengths
%     bare      handle, Z = bare (THETA): the laws, told nothing of effects
%     run       handle, Z = run (THETA, PHI): results of runs, noise included
%     measure   handle, y = measure (THETA, PHI): measured, with an error of the
%               measurement and a packing of its own
%     noiseSd   1 x T, typical noise of one run
%     isSigned  1 x K, effects that act both ways
%     plan      handle, data = plan (N0, NK), see foreignPlan
%
% run, measure and plan draw from the current random state. The laws of a
% laboratory come from lab*.m in this folder, as struct SPEC: name, parameters
% (p x 3 cell: name, limits), effects (cell: name, neutral, limits, siblings),
% laboratory (cell: name, offset, matrix, whether the law itself holds it),
% benchNames, bench, series, coordinate (as newProblem), law (handle Z = law
% (P, E) of structs of n x 1 values), relative and floor (1 x T, scatter of a
% run; where isLevel it follows the result), df (of Student's t, Inf: normal),
% rho (correlation of a run's results within a bench), precision (measurement
% error over scatter).
%
% Errors: DEcalioc:foreignLab:badValue
%
% See also: standInGap, foreignPlan, foreignTwins

function lab = foreignLab (number, change)
  if nargin < 2
    change = struct ();
  end
  makers = {@labSilo, @labDrums, @labColumns, @labBenchtop};
  if ~isscalar (number) || number < 1 || number ~= fix (number)
    error ('DEcalioc:foreignLab:badValue', ...
           ['foreignLab: NUMBER must be a whole number from 1, got %s. ', ...
            'Count the laboratories from 1.'], disp (number));
  end
  before = {rand('twister'), randn('twister')};
  restore = onCleanup (@() putBack (before));
  rand ('twister', 50000 + number);
  vary = @(x) x .* (0.9 + 0.2 * rand (size (x)));
  spec = makers{1 + mod(number - 1, numel (makers))} (vary, change);
  lab = build (spec, sprintf ('%s%d', spec.name, number));
end

function putBack (before)
  rand ('twister', before{1});
  randn ('twister', before{2});
end

function lab = build (spec, name)
  bench = spec.bench;
  limits = cell2mat (spec.parameters(:, 2:3))';
  p = columns (limits);
  scatter = scatterOf (spec, spec.law (valuesOf (spec, rand (200, p)), ...
                                       struct ()));
  lab.name = name;
  lab.noiseSd = scatter.typical;
  lab.problem = foreignProblem (spec, spec.precision .* lab.noiseSd);
  lab.isSigned = signsOf (lab.problem.effects);
  lab.means = @(theta, phi) meansOf (spec, theta, phi);
  lab.bare = @(theta) spec.law (valuesOf (spec, theta), struct ());
  same = bench' == bench;
  packing = spec.rho * same + (1 - spec.rho) * eye (numel (bench));
  reading = 0.2 * same + 0.8 * eye (numel (bench));
  lab.run = @(theta, phi) noisy (lab.means (theta, phi), scatter, packing, ...
                                 spec);
  lab.measure = @(theta, phi) lab.run (theta, phi) + ...
                foreignNoise (ones (rows (theta), 1) * lab.problem.sd, ...
                              reading, bench, spec.df);
  lab.plan = @(n0, nk) foreignPlan (lab, n0, nk);
end

function P = valuesOf (spec, theta)
  for j = 1:rows (spec.parameters)
    [name, low, high] = spec.parameters{j, :};
    P.(name) = low + theta(:, j) * (high - low);
  end
end

function isSigned = signsOf (effects)
  for k = 1:numel (effects)
    e = effects(k);
    isSigned(k) = e.laboratory || ...
                  (e.neutral > e.limits(1) && e.neutral < e.limits(2));
  end
end

function Z = meansOf (spec, theta, phi)
  n = rows (spec.effects);
  values = foreignValues ([spec.effects{:, 2}], [spec.effects{:, 3}], ...
                          phi(:, 1:n));
  E = struct ();
  for k = 1:n
    E.(spec.effects{k, 1}) = values(:, k);
  end
  for k = 1:rows (spec.laboratory)
    if spec.laboratory{k, 4}
      E.(spec.laboratory{k, 1}) = phi(:, n + k);
    end
  end
  Z = spec.law (valuesOf (spec, theta), E);
  for k = 1:rows (spec.laboratory)
    [~, offset, matrix, isInLaw] = spec.laboratory{k, :};
    change = zeros (1, columns (Z));
    if ~isempty (offset)
      change = change + offset;
    end
    if ~isempty (matrix)
      change = change + Z * matrix;
    end
    Z = Z + ~isInLaw * phi(:, n + k) .* change;
  end
end

% Scatter of a run, as a function of its results or not; typical: the median
% over the box.
function scatter = scatterOf (spec, Z)
  sd = sqrt (spec.floor.^2 + (spec.relative .* Z).^2);
  scatter.typical = median (sd, 1);
end

function Z = noisy (Z, scatter, packing, spec)
  sd = ones (rows (Z), 1) * scatter.typical;
  if spec.isLevel
    sd = sqrt (spec.floor.^2 + (spec.relative .* Z).^2);
  end
  Z = Z + foreignNoise (sd, packing, spec.bench, spec.df);
end

% As newProblem wants it, the value still NaN; SD is that of the measurement.
function problem = foreignProblem (spec, sd)
  T = numel (spec.bench);
  limits = cell2mat (spec.parameters(:, 2:3))';
  effects = struct ('name', {}, 'variables', {}, 'neutral', {}, 'limits', ...
                    {}, 'siblings', {}, 'laboratory', {}, 'offset', {}, ...
                    'matrix', {});
  for k = 1:rows (spec.effects)
    [name, neutral, range, siblings] = spec.effects{k, :};
    effects(end + 1) = struct ('name', name, 'variables', {{name}}, ...
                               'neutral', neutral, 'limits', range, ...
                               'siblings', {siblings}, 'laboratory', ...
                               false, 'offset', [], 'matrix', []);
  end
  for k = 1:rows (spec.laboratory)
    [name, offset, matrix] = spec.laboratory{k, 1:3};
    effects(end + 1) = struct ('name', name, 'variables', {{}}, ...
                               'neutral', [], 'limits', zeros (2, 0), ...
                               'siblings', {{}}, 'laboratory', true, ...
                               'offset', offset, 'matrix', matrix);
  end
  problem = struct ('value', NaN (1, T), 'sd', sd, 'bench', spec.bench, ...
                    'limits', limits, 'effects', effects);
  problem.benchNames = spec.benchNames;
  problem.names = spec.parameters(:, 1)';
  problem.series = spec.series;
  problem.coordinate = spec.coordinate;
end

% Correlated within a bench; heavy tails strike a run of a bench as a whole
% (multivariate t, DF degrees of freedom; Inf: normal), of standard deviation SD.
function noise = foreignNoise (sd, correlation, bench, df)
  [n, T] = size (sd);
  noise = randn (n, T) * chol (correlation);
  if isfinite (df)
    for b = unique (bench)
      at = bench == b;
      spread = sqrt ((df - 2) ./ sum (randn (n, df).^2, 2));
      noise(:, at) = noise(:, at) .* spread;
    end
  end
  noise = sd .* noise;
end

%!test % same laws each time, random state untouched, other laws for others
%! rand ('twister', 5);
%! a = foreignLab (2);
%! first = rand ();
%! rand ('twister', 5);
%! assert (rand (), first);
%! theta = [0.2, 0.4, 0.6];
%! b = foreignLab (2);
%! c = foreignLab (6);
%! assert (a.bare (theta), b.bare (theta));
%! assert (norm (a.bare (theta) - c.bare (theta)) > 1e-3);
%! assert (c.name, 'drums6');
%!test % another setting: other results of that bench, the others as they were
%! a = foreignLab (1);
%! b = foreignLab (1, struct ('load', [3, 4, 5, 6] * 1000));
%! theta = 0.4 * ones (1, 4);
%! change = b.bare (theta) - a.bare (theta);
%! assert (change(1:11), zeros (1, 11));
%! assert (all (change(12:15) > 0));
%!test % typical scatter: that of runs, standard deviation of 4000 within 15 %
%! % (t with 4 degrees of freedom: the standard error is about 3 %)
%! for number = 1:4
%!   rand ('twister', 1);
%!   randn ('twister', 1);
%!   lab = foreignLab (number);
%!   p = columns (lab.problem.limits);
%!   K = numel (lab.problem.effects);
%!   Z = lab.run (0.5 * ones (4000, p), zeros (4000, K));
%!   spread = 1.4826 * median (abs (Z - median (Z)));
%!   assert (all (spread > 0.3 * lab.noiseSd & spread < 2.5 * lab.noiseSd));
%! end
%!test % a measurement: packing and error, here as large
%! randn ('twister', 1);
%! lab = foreignLab (2);
%! y = lab.measure (0.5 * ones (4000, 3), zeros (4000, 8));
%! whole = sqrt (lab.noiseSd.^2 + lab.problem.sd.^2);
%! assert (std (y) ./ whole, ones (size (whole)), 0.06);
%!test % the diagnosis takes every laboratory as it is described
%! for number = 1:4
%!   lab = foreignLab (number);
%!   given = lab.problem;
%!   given.value = lab.means (0.5 * ones (1, columns (given.limits)), ...
%!                            zeros (1, numel (given.effects)));
%!   problem = newProblem (given);
%!   assert (numel (problem.effects), numel (given.effects));
%! end
%!error id=DEcalioc:foreignLab:badValue foreignLab (0)

% SPDX-License-Identifier: GPL-3.0-only
