% MEASURECURE  Answers HOW FAR the gap shrinks once an effect is modelled.
%
% CALL: [CURE, STATE] = measureCure (VIEW, CAUSES, STATE)
%
%   VIEW     struct problem, em, models, fits: of newGapProblem, fitEmulator,
%            makeModels, fitLibrary (first row: the measured values)
%   CAUSES   1 x m cell of effect numbers in MODELS: the cause first, then the
%            placebos, each refitted alike on the used targets only
%   STATE    struct of spendRuns, with repeats (seeds at each compared set)
%   CURE     struct
%     effect   text, names of the effects that were added
%     before, after, floor, closure, interval90   on the used targets
%     heldOut  the same on the held-out targets ([] if there are none)
%     placebos 1 x (m - 1) struct effect, closure, heldOut
%     verifiedByDEM logical, worstZ (largest deviation of the DEM mean from the
%       surrogate in standard deviations, NaN: not run)
%     params   2 x p, without and with the effect;  phi  1 x h, strengths
%     remaining 1 x n, deviation of each used target after the cure, in its
%       standard deviations
%
% With fewer runs left, fewer seeds; with less than two seeds a set surrogates
% stand in for DEM and verifiedByDEM is false.
%
% See also: closureOf, diagnoseMatrices

function [cure, state] = measureCure (view, causes, state)
  problem = view.problem;
  em = view.em;
  models = view.models;
  sets = {struct('h', [], 'Q', view.fits.null.Q(1, :))};
  for i = 1:numel (causes)
    sets{i + 1} = refit (models, view.fits, causes{i});
  end
  verify = ~isempty (state.evaluate) && state.left >= 2 * numel (sets);
  if verify
    state.repeats = min (state.repeats, floor (state.left / numel (sets)));
  end
  noise = noiseOf (problem, em);
  Z = cell (1, numel (sets));
  worst = NaN (1, numel (sets));
  for i = 1:numel (sets)
    if verify
      [Z{i}, worst(i), state] = runSet (view, sets{i}, state);
    end
    if any (isnan (mean (Z{i}, 1)(:))) || rows (Z{i}) < 2
      Z{i} = drawSet (em, sets{i}, state.repeats);
      verify = false;
    end
  end
  cure = closureAt (problem, em, noise, Z{1}, Z{2}, problem.used);
  cure.effect = strjoin (models.names(causes{1}), ' + ');
  cure.heldOut = [];
  if ~isempty (problem.heldOut)
    cure.heldOut = closureAt (problem, em, noise, Z{1}, Z{2}, problem.heldOut);
  end
  cure.placebos = struct ('effect', {}, 'closure', {}, 'heldOut', {});
  for i = 3:numel (sets)
    own = closureAt (problem, em, noise, Z{1}, Z{i}, problem.used);
    held = NaN;
    if ~isempty (problem.heldOut)
      held = closureAt (problem, em, noise, Z{1}, Z{i}, ...
                        problem.heldOut).closure;
    end
    names = strjoin (models.names(sets{i}.h), ' + ');
    cure.placebos(end + 1) = struct ('effect', names, ...
                                     'closure', own.closure, 'heldOut', held);
  end
  cure.verifiedByDEM = verify;
  cure.worstZ = max (worst(1:2));
  half = diff (problem.limits) / 2;
  cure.params = mean (problem.limits) + ...
                [sets{1}.Q; sets{2}.Q(1:em.p)] .* half;
  cure.phi = sets{2}.Q(em.p + 1:end);
  left = problem.y(problem.used) - mean (Z{2}(:, problem.used), 1);
  cure.remaining = left ./ sqrt (noise(problem.used));
end

function set = refit (models, fits, h)
  if isscalar (h)
    set = struct ('h', h, 'Q', fits.single{h}.Q(1, :));
    return
  end
  box = hypothesisBox (models.white, h, models.prior);
  a = fits.single{h(1)}.Q(1, :);
  b = fits.single{h(2)}.Q(1, :);
  p = models.white.p;
  Q = [a, b(end); a, 0.1; b(1:p), 0.1, b(end)];
  fit = fitHypothesis (models.white, h, repmat (fits.Z(1, :), 3, 1), Q, box);
  [~, best] = min (fit.cost);
  set = struct ('h', h, 'Q', fit.Q(best, :));
end

function noise = noiseOf (problem, em)
  budget = noiseBudget (problem, em);
  noise = diag (budget.covariance)';
end

% Effects of the laboratory act on the results of a neutral run.
function [Z, worst, state] = runSet (view, set, state)
  problem = view.problem;
  em = view.em;
  n = state.repeats;
  phi = zeros (1, numel (problem.effects));
  number = zeros (1, numel (set.h));
  for i = 1:numel (set.h)
    at = find (strcmp ({problem.effects.name}, view.models.names{set.h(i)}), 1);
    number(i) = at;
    phi(at) = set.Q(em.p + i);
  end
  known = rows (state.data.Z);
  state = spendRuns (state, problem, repmat (set.Q(1:em.p), n, 1), ...
                     repmat (phi, n, 1), (1:n)', 'cure');
  Z = state.data.Z(known + 1:end, :);
  for at = number
    effect = problem.effects(at);
    if effect.laboratory
      Z = Z + phi(at) * (effect.offset + Z * effect.matrix);
    end
  end
  Z = Z(all (isfinite (Z), 2), :);
  used = problem.used;
  M = predictGap (em, set.h, set.Q);
  sd = sqrt (mean (em.surrogateVar, 1) + em.seedVar / max (rows (Z), 1));
  worst = max (abs (mean (Z(:, used), 1) - M(used)) ./ sd(used));
end

% N draws whose mean is as uncertain as the surrogate.
function Z = drawSet (em, set, n)
  M = predictGap (em, set.h, set.Q);
  draws = integrationPoints (2 * n, columns (M), 31).normal(1:n, :);
  draws = draws - mean (draws, 1);
  Z = M + sqrt (n * mean (em.surrogateVar, 1)) .* draws;
end

function c = closureAt (problem, em, noise, before, after, at)
  c = closureOf (problem.y(at), noise(at), before(:, at), after(:, at), ...
                 em.range(at));
end
