% EXPLOREEFFECTS  Runs candidate effects: a few for all, a plan for survivors.
%
% CALL: [STATE, EM] = exploreEffects (GAPPROBLEM, OPTIONS, STATE, EM)
%
%   GAPPROBLEM, OPTIONS  of newGapProblem, gapOptions
%   STATE                of newGapState
%   EM                   of fitEmulator, fitted to STATE.data
%
% First OPTIONS.screenRuns for every effect that has fewer; then, if there is a
% gap at all, OPTIONS.planRuns for the OPTIONS.survivors likeliest ones, in two
% rounds, placed by the posterior. Runs that verify the cure are set aside
% before, and four runs of the likeliest pair made. Nothing is run without
% STATE.evaluate. In a case with levels these runs are of the first one, but for
% one a round and survivor, at the mean of its posterior.

function [state, em] = exploreEffects (gapProblem, options, state, em)
  if isempty (state.evaluate) || state.left < 1 || isempty (em.effect)
    return
  end
  reserve = min (4 * options.verifyRuns, floor (state.left / 3));
  state.left = state.left - reserve;
  theta = calibrateNull (gapProblem, em, options);
  wanted = zeros (1, numel (em.effect));
  wanted(~[em.effect.laboratory]) = options.screenRuns;
  state = runEffects (gapProblem, state, em, theta, wanted, []);
  em = emulate (gapProblem, state.data, options, em);
  full = options.planRuns;
  if isempty (full)
    full = 5 * (em.p + 1);
  end
  for share = [0.5, 1]
    [wanted, posteriors] = survivors (gapProblem, options, em, ...
                                      ceil (share * full));
    if ~any (wanted)
      break
    end
    state = runEffects (gapProblem, state, em, theta, wanted, posteriors);
    em = emulate (gapProblem, state.data, options, em);
  end
  [state, em] = runBestPair (gapProblem, options, state, em);
  state.left = state.left + reserve;
end

% Pairs are not merely added: where one is likely, four runs of both effects
% show what they do together.
function [state, em] = runBestPair (gapProblem, options, state, em)
  [w, verdict, usable] = weighNow (gapProblem, options, em);
  if isempty (w) || state.left < 4
    return
  end
  pairs = find (strcmp (w.kind, 'pair'));
  [most, at] = max ([verdict.P(pairs), 0]);
  if most < options.pairAt || isempty (w.posterior{pairs(at)}.Q)
    return
  end
  members = usable(w.members{pairs(at)});
  if any ([em.effect(members).laboratory])
    return
  end
  posterior = w.posterior{pairs(at)};
  middle = posterior.weight' * posterior.Q;
  top = vertcat (gapProblem.effects(members).range)(:, 2)';
  phi = zeros (4, numel (em.effect));
  phi(:, members) = [middle(em.p + (1:2)); top; top .* [1, 0.5]; ...
                     top .* [0.5, 1]];
  theta = repmat (middle(1:em.p), 4, 1);
  state = spendRuns (state, gapProblem, theta, phi, ones (4, 1));
  em = emulate (gapProblem, state.data, options, em);
end

function [w, verdict, usable] = weighNow (gapProblem, options, em)
  w = [];
  verdict = [];
  usable = find ([em.effect.laboratory] | [em.effect.runs] >= 2);
  if isempty (usable)
    return
  end
  library = withoutEffects (em, setdiff (1:numel (em.effect), usable));
  quick = options;
  quick.twins = min (options.twins, 99);
  models = makeHypotheses (gapProblem, library, quick);
  fits = fitLibrary (models, gapProblem.value(gapProblem.used));
  models = omnibusReference (models);
  w = caseEvidence (models, fits, 1);
  verdict = judgeCase (w, models);
  if w.gate.p > 2 * options.level
    w = [];
  end
end

function state = runEffects (gapProblem, state, em, theta, wanted, posteriors)
  K = numel (em.effect);
  hasLevels = isfield (state.data, 'level');
  all = strengthOfValues (gapProblem.effects, state.data.E);
  half = diff (gapProblem.limits) / 2;
  X = (state.data.X - mean (gapProblem.limits)) ./ half;
  Theta = zeros (0, em.p);
  Phi = zeros (0, K);
  isFine = false (0, 1);
  for k = find (wanted > 0)
    own = abs (all(:, k)) > 1e-9 & sum (abs (all) > 1e-9, 2) == 1;
    posterior = [];
    if ~isempty (posteriors)
      posterior = posteriors{k};
    end
    n = max (wanted(k) - sum (own), 0);
    Q = planEffectRuns (n, [X(own, :), all(own, k)], theta, posterior, ...
                        gapProblem.effects(k).range);
    isFine = [isFine; repmat(~hasLevels, n, 1)];
    if hasLevels && n > 0 && ~isempty (posterior)
      Q(end, :) = posterior.weight' * posterior.Q(:, 1:em.p + 1);
      isFine(end) = true;
    end
    Theta = [Theta; Q(:, 1:end - 1)];
    rows_ = zeros (n, K);
    rows_(:, k) = Q(:, end);
    Phi = [Phi; rows_];
  end
  stages = {'gap', 'coarse'};
  for at = {isFine, ~isFine}
    state = spendRuns (state, gapProblem, Theta(at{1}, :), Phi(at{1}, :), ...
                       ones (sum (at{1}), 1), stages{1});
    stages(1) = [];
  end
end

function [wanted, posteriors] = survivors (gapProblem, options, em, runs)
  K = numel (em.effect);
  wanted = zeros (1, K);
  posteriors = cell (1, K);
  [w, verdict, usable] = weighNow (gapProblem, options, em);
  if isempty (w)
    return
  end
  singles = find (strcmp (w.kind, 'single'));
  likely = verdict.total;
  likely([em.effect(usable).laboratory]) = -Inf;
  [~, order] = sort (-likely);
  order = order(isfinite (likely(order)));
  for i = order(1:min (options.survivors, numel (order)))
    k = usable(i);
    wanted(k) = runs;
    posteriors{k} = w.posterior{singles(i)};
  end
end
