% MEASURECURE  Answers HOW FAR the gap shrinks once an effect is modelled.
%
% CALL: CURE = measureCure (STUDY, SETS, FIRST)
%
%   STUDY     struct problem, emulator, hypotheses
%   SETS     struct array of runCures: the null model first, then each
%            effect
%   FIRST    effect numbers of the cause, one of SETS
%   CURE     struct
%     effect   text, names of the effects that were added
%     before, after, floor   of the used targets: root mean square
%              deviations in units of each target's range over the box, and what
%              noise makes of them
%     closure, interval90, gapP, largestZ, removable   of closureOf
%     heldOut  the same on the held-out targets ([] if there are none)
%     targets  1 x n struct target (number), before, after (means of the
%              model), sdBefore, sd (of the measured value less these)
%     placebos 1 x m struct: the other effects, refitted alike: effect, closure,
%              interval90, heldOut (closure), verifiedByDEM, and
%       expected    closure that it would have if the cause is right: the square
%                   of the cosine of what the two add, as far as parameters
%                   cannot hide it
%       difference, difference90   closure of the cause less its own
%       logRatio    log density of the held-out values with the cause over that
%                   with the placebo, NaN: none held out
%       against     logical, it closes more than expected, and no less than the
%                   cause (5 % each), both by DEM
%     verifiedByDEM logical: before and after are of DEM runs (a placebo may
%              be of surrogates where the runs ended)
%     worstZ   largest deviation of the DEM mean from the surrogate in standard
%              deviations, NaN: not run
%     params   2 x p, without and with the effect;  phi  1 x h, strengths
%     remaining 1 x n, deviation of each used target after the cure, in
%       standard deviations of measurement, packing and the mean of the runs;
%       stillMisses  logical: of DEM runs, and one of these beyond leftAt of
%       gapOptions
%
% All draws share the measurement and the runs without the effect, so that
% cause and placebo are compared in pairs.

function cure = measureCure (study, sets, first)
  problem = study.problem;
  emulator = study.emulator;
  names = study.hypotheses.names;
  options = study.hypotheses.options;
  at = find (cellfun (@(h) isequal (h, first), {sets.h}), 1);
  devs = deviationsOf (study, sets);
  targets = [problem.used, problem.heldOut];
  used = 1:numel (problem.used);
  held = numel (used) + 1:numel (targets);
  scale = emulator.range(targets);
  cure = closureAt (devs([1, at]), used, scale, options);
  cure.effect = strjoin (names(first), ' + ');
  cure.heldOut = [];
  if ~isempty (held)
    c = closureAt (devs([1, at]), held, scale, options);
    cure.heldOut = rmfield (c, 'share');
  end
  cure.targets = targetsOf (problem, targets, devs(1), devs(at));
  cure.placebos = struct ('effect', {}, 'closure', {}, 'interval90', {}, ...
                          'heldOut', {}, 'verifiedByDEM', {}, ...
                          'expected', {}, 'difference', {}, ...
                          'difference90', {}, 'logRatio', {}, 'against', {});
  for i = setdiff (2:numel (sets), at)
    if any (ismember (sets(i).h, first))
      continue
    end
    placebo = placeboOf (cure, devs([1, at, i]), used, held, ...
                         {scale, options});
    placebo.effect = strjoin (names(sets(i).h), ' + ');
    placebo.verifiedByDEM = sets(i).verified;
    placebo.against = placebo.against && all ([sets([1, at, i]).verified]);
    cure.placebos(end + 1) = orderfields (placebo, cure.placebos);
  end
  cure = rmfield (cure, 'share');
  cure.verifiedByDEM = all ([sets([1, at]).verified]);
  cure.worstZ = max ([sets([1, at]).worstZ]);
  cure.params = fromSymmetric ([sets(1).Q; sets(at).Q(1:emulator.p)], problem.limits);
  cure.phi = sets(at).Q(emulator.p + 1:end);
  noise = diag (noiseBudget (problem, emulator).covariance)';
  cure.remaining = devs(at).r(used) ./ ...
                   sqrt (noise(problem.used) + devs(at).scatter(used));
  cure.stillMisses = cure.verifiedByDEM && ...
                     max (abs (cure.remaining)) > options.leftAt;
end

function devs = deviationsOf (study, sets)
  n = numel ([study.problem.used, study.problem.heldOut]);
  p = max (arrayfun (@(s) numel (s.Q), sets));
  % one measurement: its draws are the same for all sets, which compares them in pairs
  normal = integrationPoints (1000, 3 * n + p, 7).normal;
  draws = struct ('noise', normal(:, 1:n), ...
                  'surrogate', normal(:, n + (1:n)), ...
                  'prior', normal(:, 2 * n + (1:p)), ...
                  'run', normal(:, 2 * n + p + (1:n)));
  for i = numel (sets):-1:1
    % runs of other sets have other seeds
    draws.run = circshift (draws.run, 2, 1);
    devs(i) = deviationOf (study, sets(i), draws);
  end
end

% D  deviations without and with an effect; held-out targets are measured by
% the noise that a prediction has.
function c = closureAt (d, at, scale, options)
  metric = inv (d(1).Sigma(at, at));
  if at(1) > 1
    metric = inv (d(1).F(at, at));
  end
  parts = partOf (d, at);
  rms = @(x) sqrt (mean (x ./ scale(at).^2));
  c = struct ('before', rms (parts(1).r.^2), 'after', rms (parts(2).r.^2), ...
              'floor', rms (diag (parts(1).F)'));
  closed = closureOf (parts(1), parts(2), metric, options);
  for field = fieldnames (closed)'
    c.(field{1}) = closed.(field{1});
  end
end

function parts = partOf (d, at)
  parts = struct ('r', {}, 'F', {}, 'E', {}, 'nu', {});
  for one = d
    parts(end + 1) = struct ('r', one.r(at), 'F', one.F(at, at), ...
                             'E', one.E(:, at), 'nu', one.nu);
  end
end

% D  deviations without effect, with the cause, with the placebo
function placebo = placeboOf (cure, d, used, held, how)
  c = closureAt (d([1, 3]), used, how{:});
  placebo = struct ('closure', c.closure, 'interval90', c.interval90, ...
                    'heldOut', NaN, 'logRatio', NaN);
  placebo.expected = alikeness (d, used);
  placebo.difference = cure.closure - c.closure;
  gain = cure.share - c.share;
  gain = gain(isfinite (gain));
  placebo.difference90 = [NaN, NaN];
  if c.removable && ~isempty (gain)
    placebo.difference90 = weightedQuantile (gain, ones (size (gain)), ...
                                             [0.05, 0.95]);
  end
  placebo.against = c.interval90(1) > placebo.expected && placebo.difference90(1) <= 0;
  if ~isempty (held)
    placebo.heldOut = closureAt (d([1, 3]), held, how{:}).closure;
    parts = partOf (d, held);
    placebo.logRatio = logDensity (parts(2)) - logDensity (parts(3));
  end
end

% Squared cosine of what two effects add, parameters taken out; 0 where they
% push the targets opposite ways.
function share = alikeness (d, used)
  L = chol (d(1).Sigma(used, used), 'lower');
  N = parityProjection (L \ d(1).J(used, :), zeros (numel (used), 1)).N;
  % as far as parameters cannot hide it, in units of the noise
  a = N' * (L \ d(2).s(used)');
  b = N' * (L \ d(3).s(used)');
  share = max (a' * b, 0)^2 / max ((a' * a) * (b' * b), realmin);
end

% Student's density of R in several dimensions, covariance estimated.
function L = logDensity (d)
  n = numel (d.r);
  nu = min (d.nu, 1e4);
  q = d.r * (d.F \ d.r');
  L = gammaln ((nu + n) / 2) - gammaln (nu / 2) - n / 2 * log (nu * pi) - ...
      sum (log (diag (chol (d.F)))) - (nu + n) / 2 * log1p (q / nu);
end

function list = targetsOf (problem, targets, before, after)
  list = struct ('target', {}, 'before', {}, 'after', {}, 'sdBefore', {}, ...
                 'sd', {});
  for i = 1:numel (targets)
    value = problem.value(targets(i));
    list(i) = struct ('target', targets(i), 'before', value - before.r(i), ...
                      'after', value - after.r(i), ...
                      'sdBefore', sqrt (before.F(i, i)), ...
                      'sd', sqrt (after.F(i, i)));
  end
end

%!test
%! % a placebo whose runs were cut off takes nothing from a cure that was run
%! [given, data] = smallGapLab ();
%! given.value = mean (data.Z);
%! study = labStudy (given, data);
%! p = study.emulator.p;
%! set = struct ('h', zeros (1, 0), 'Q', zeros (1, p), ...
%!               'Z', data.Z(1:3, :), 'worstZ', 1, 'verified', true);
%! cured = setfield (setfield (set, 'h', 1), 'Q', zeros (1, p + 1));
%! cut = setfield (setfield (cured, 'h', 2), 'verified', false);
%! cure = measureCure (study, [set, cured, cut], 1);
%! assert (cure.verifiedByDEM);
%! assert ({cure.placebos.effect}, study.hypotheses.names(2));
%! assert (! cure.placebos.verifiedByDEM);
%! cure = measureCure (study, [set, cured, cut], 2);
%! assert (! cure.verifiedByDEM);
%!test
%! % by DEM, without noise in the fit: the cause closes all, a placebo the
%! % square of its cosine, which is no case against the cause
%! [given, data, means] = smallGapLab ();
%! truth = [0.1, 0.3];
%! given.value = means ((truth + 1) / 2, [0, 0, 0.6, 0, 0]);
%! given.held = (1:12) > 9;
%! given.trials = Inf;
%! study = labStudy (given, data);
%! runs = @(X, E, r) means (X, [E, zeros(rows (E), 1)]);
%! options = gapOptions (struct ('maxNewRuns', 99, 'verifyRuns', 5));
%! state = newGapState (data, options, runs);
%! sets = runCures (study, {3, 4}, state);
%! cure = measureCure (study, sets, 3);
%! assert (cure.closure, 1, 0.03);
%! assert (cure.heldOut.closure, 1, 0.05);
%! p = cure.placebos;
%! assert (p.closure, p.expected, 0.05);
%! assert (p.closure + p.difference, cure.closure, 1e-9);
%! assert (p.difference90(1) > 0 && ! p.against);
%! assert (p.logRatio > 0);
%! assert ([cure.targets.target], 1:12);
%! % had the placebo been fitted to data of its own, the name would be wrong
%! sets(3).Z = sets(2).Z;
%! cure = measureCure (study, sets, 3);
%! assert (cure.placebos.difference, 0, 0.01);
%! assert (cure.placebos.against);
%!test
%! % the right cause at the right set: however sure the measurement is, the
%! % scatter of the runs misses nothing (seeded)
%! [given, data, means] = smallGapLab ();
%! truth = [0.1, 0.3];
%! given.value = means ((truth + 1) / 2, [0, 0, 0.6, 0, 0]);
%! [given.sd(:), given.trials] = deal (0.01, Inf);
%! study = labStudy (given, data);
%! set = @(h, Q, phi) struct ('h', h, 'Q', Q, 'Z', ...
%!   means (repmat ((truth + 1) / 2, 5, 1), repmat (phi, 5, 1)) + ...
%!   0.2 * randn (5, 12), 'worstZ', 1, 'verified', true);
%! randn ('twister', 1);
%! sets = [set(zeros (1, 0), truth, zeros (1, 5)), ...
%!         set(3, [truth, 0.6], [0, 0, 0.6, 0, 0])];
%! cure = measureCure (study, sets, 3);
%! assert (~cure.stillMisses);
%! assert (max (abs (cure.remaining)) > 1);
%! sets(2).Z = sets(2).Z + 1;
%! assert (measureCure (study, sets, 3).stillMisses);

% SPDX-License-Identifier: GPL-3.0-only
