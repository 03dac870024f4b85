% PROPOSERUNS  The next batch of runs, by what they tell about the cause.
%
% CALL: BATCH = proposeRuns (PROBLEM, OPTIONS, STATE, EMULATOR, NOW)
%
%   PROBLEM, OPTIONS, STATE, EMULATOR  as of exploreEffects
%   NOW    struct evidence, verdict (caseEvidence, judgeCase), hypotheses, fits, usable
%          (numbers of their effects in EMULATOR), runs (of each, Inf: none needed),
%          tried (the same with those that gave no result),
%          isVague (the mark of the likeliest one needs more runs), alike (the
%          likeliest and the one most like it, or []), rivals (need more runs,
%          equally many, to be parted)
%   BATCH  struct theta (n x p), phi (n x K), isFine (n x 1 logical: at the last
%          level, where a case has levels), bits (scalar, expected information
%          about the cause; Inf: runs that a name needs, whatever they tell)
%
% Candidates: of each of the four likeliest effects, and of the one most like
% the likeliest, that has less than OPTIONS.mostRuns its mode and the posterior
% draws farthest from its runs (of one that isVague the farthest of all its
% range and box); the model without an effect at the mode of the likeliest; a
% likely pair at its middle. What a run z of hypothesis h tells: y, the
% measurement, is known. Were h the cause, the error of its surrogate were what
% y says of it, z ~ N (M + R (R + S)^-1 (y - M), what that leaves); else y says
% nothing of it, z ~ N (M, R + noise). With the probability of h, that of the
% two that z is expected to give back is the information (mixtureInformation). R
% is the variance of the surrogates and of the amplitude (predictHypothesis), S
% that of measurement, packing and where h would stand. Runs of the same effect
% in one batch tell in part the same.

function batch = proposeRuns (problem, options, state, emulator, now)
  pool = candidates (problem, options, state, emulator, now);
  noise = noiseBudget (problem, emulator);
  for i = 1:numel (pool)
    pool(i).parts = twoStories (problem, emulator, noise, pool(i));
  end
  K = numel (emulator.effect);
  batch = struct ('theta', zeros (0, emulator.p), 'phi', zeros (0, K), 'isFine', ...
                  false (0, 1), 'bits', 0);
  taken = zeros (1, numel (pool));
  while rows (batch.theta) < min (options.batch, state.budget.sets) && ~all (taken)
    bits = -Inf (size (taken));
    for i = find (~taken)
      bits(i) = told (pool(i), sum (strcmp ({pool(taken > 0).what}, ...
                                            pool(i).what)));
    end
    [most, best] = max (bits);
    if most < options.worthAt / options.batch && ~isempty (batch.theta)
      return
    end
    taken(best) = 1;
    one = pool(best);
    phi = zeros (1, K);
    phi(one.members) = one.q(emulator.p + 1:end);
    batch.theta(end + 1, :) = one.q(1:emulator.p);
    batch.phi(end + 1, :) = phi;
    batch.isFine(end + 1, 1) = one.isMode;
    batch.bits = batch.bits + most;
  end
end

function pool = candidates (problem, options, state, emulator, now)
  evidence = now.evidence;
  p = emulator.p;
  pool = struct ('what', {}, 'members', {}, 'q', {}, 'P', {}, 'isMode', {}, ...
                 'spread', {}, 'story', {}, 'lacks', {});
  [total, order] = sort (-now.verdict.include);
  order = unique ([order(1:min (4, numel (order))), now.alike, ...
                   now.rivals], 'stable');
  % rivals get runs in turn, those with the fewest first: none wins by being better
  % known
  turn = 1 + min ([now.runs(now.rivals), Inf]);
  isSure = -total(1) >= options.standsAt;
  singles = find (strcmp (evidence.kind, 'single'));
  for i = order(:)'
    k = now.usable(i);
    isVague = now.isVague && i == order(1);
    peak = now.fits.of{now.hypotheses.singles(i)}.Q(1, 1:p + 1);
    posterior = evidence.posterior{singles(i)};
    blank = struct ('what', emulator.effect(k).name, 'members', k, 'q', peak, ...
                    'P', now.verdict.include(i), 'isMode', true, ...
                    'spread', posterior, 'story', k, 'lacks', 0);
    if i == order(1)
      pool(end + 1) = setfield (setfield (blank, 'members', []), 'what', '');
      pool(end).q = peak(1:p);
    end
    if now.runs(i) >= options.mostRuns || isempty (posterior.Q)
      continue
    end
    if isSure
      blank.lacks = max ([(options.standsRuns - now.runs(i)) * ...
                          any(i == order(1:min (2, end))), ...
                          (options.alikeRuns - now.tried(i)) * ...
                          any(i == now.alike), options.batch * isVague]);
    end
    if any (i == now.rivals)
      blank.lacks = max (blank.lacks, turn - now.runs(i));
    end
    pool(end + 1) = blank;
    n = 3;
    if isVague
      % where it is fitted badly, its posterior says little of where to run it
      n = options.batch;
      posterior = wholeBox (options, p, problem.effects(k).range);
    end
    Q = planEffectRuns (n, [emulator.effect(k).Q; peak], peak(1:p), posterior, ...
                        problem.effects(k).range);
    for q = Q'
      pool(end + 1) = setfield (setfield (blank, 'q', q'), 'isMode', false);
    end
  end
  phi = strengthOfValues (problem.effects, state.data.E);
  failed = phi(~any (isfinite (state.data.Z), 2), :);
  pool = [pool, likelyPair(options, emulator, now, failed)];
end

function sample = wholeBox (options, p, range)
  n = 400;
  u = integrationPoints (n, p + 1, options.seed).uniform;
  sample = struct ('Q', [2 * u(:, 1:p) - 1, ...
                         range(1) + u(:, end) * diff(range)], ...
                   'weight', ones (n, 1) / n);
end

% Pairs are not merely added: where one is likely, runs of both effects show
% what they do together. Not of a pair that gave no result before: LIGGGHTS has
% cohesion or liquid bridges. FAILED, n x K: strengths of such runs.
function pool = likelyPair (options, emulator, now, failed)
  pool = [];
  pairs = find (strcmp (now.evidence.kind, 'pair'));
  [most, at] = max ([now.verdict.P(pairs), 0]);
  if most < options.pairAt || isempty (now.evidence.posterior{pairs(at)}.Q)
    return
  end
  members = now.usable(now.evidence.members{pairs(at)});
  posterior = now.evidence.posterior{pairs(at)};
  if any ([emulator.effect(members).laboratory]) || ...
     any (all (abs (failed(:, members)) > 1e-9, 2))
    return
  end
  middle = posterior.weight' * posterior.Q(:, 1:emulator.p + 2);
  pool = struct ('what', 'pair', 'members', members, 'q', middle, 'P', most, ...
                 'isMode', true, 'spread', posterior, 'story', members, ...
                 'lacks', 0);
  % what two do together shows most where both are strong
  full = middle;
  for i = 1:2
    full(emulator.p + i) = emulator.effect(members(i)).strongest * ...
                     sign (middle(emulator.p + i) + realmin);
  end
  pool(2) = setfield (setfield (pool, 'q', full), 'isMode', false);
end

% The result of the run if its hypothesis is the cause, and if it is not.
function parts = twoStories (problem, emulator, noise, one)
  at = problem.used;
  p = emulator.p;
  Q = one.spread.Q(:, 1:p + numel (one.story));
  M = predictGap (emulator, one.story, Q)(:, at);
  D = (M - one.spread.weight' * M) .* sqrt (one.spread.weight);
  story = one.q;
  if isempty (one.members)
    story = one.spread.weight' * Q;
    story(1:p) = one.q;
  end
  [mean_, R] = outcome (emulator, one.story, story, at);
  whole = R + noise.covariance(at, at) + D' * D;
  [own, R] = outcome (emulator, one.members, one.q, at);
  run_ = diag (emulator.noiseVar(at));
  gain = R / whole;
  r = problem.value(at) - mean_;
  left = R - gain * R;
  parts = struct ('mean', {own + r * gain', own}, ...
                  'cov', {(left + left') / 2 + run_, R + run_});
end

% Mean of a hypothesis and covariance of the error of its surrogates.
function [M, R] = outcome (emulator, members, q, at)
  p = emulator.p;
  M = predictGap (emulator, members, q)(at);
  sd = sqrt (baseVariance (emulator, q(1:p)))(at);
  R = (sd' * sd) .* emulator.correlation(at, at);
  R = R + effectError (emulator, members, q)(at, at);
end

% Bits of a run where N of the same effect are in the batch already.
function bits = told (one, n)
  if n < one.lacks
    % runs that a name needs come before all that only inform
    bits = 1e3 - n + one.isMode;
    return
  end
  parts = one.parts;
  % runs of one effect tell in part the same: each leaves half to the next
  parts(1).mean = parts(2).mean + 0.5^n * (parts(1).mean - parts(2).mean);
  parts(1).cov = parts(2).cov + 0.5^n * (parts(1).cov - parts(2).cov);
  P = min (max (one.P, 1e-6), 1 - 1e-6);
  bits = mixtureInformation (parts, [P, 1 - P], [1, 2]);
end

%!function study = labOf (strengths)
%!  [given, data, means] = smallGapLab ();
%!  given.value = means ([0.4, 0.6], strengths);
%!  study = labStudy (given, data, struct ('maxNewRuns', 30, 'twins', 60));
%!  study.state = newGapState (data, study.hypotheses.options, @(X, E, r) 0);
%!  hypotheses = gapReference (study.hypotheses);
%!  evidence = caseEvidence (hypotheses, study.fits, 1);
%!  study.now = struct ('evidence', evidence, 'verdict', ...
%!                      judgeCase (evidence, hypotheses), 'hypotheses', hypotheses, ...
%!                      'fits', study.fits, 'usable', 1:5, 'isVague', false, ...
%!                      'runs', [], 'tried', [], 'alike', [], 'rivals', []);
%!endfunction
%!function [study, state, now] = after (study, runs)
%!  [state, now] = deal (study.state, study.now);
%!  [now.runs, now.tried] = deal (runs);
%!endfunction
%!function batch = proposed (study, state, now)
%!  batch = proposeRuns (study.problem, study.hypotheses.options, state, ...
%!                       study.emulator, now);
%!endfunction
%!shared one
%! one = labOf ([0.6, 0, 0, 0, 0]);
%!test
%! % the likeliest effect has one run and needs more before a name; the others
%! % have enough, as it has later: what is left tells little
%! [study, state, now] = after (one, [1, 9, 9, 9, Inf]);
%! now.verdict.include = [0.96, 0.02, 0.01, 0.01, 0];
%! batch = proposed (study, state, now);
%! assert (sum (batch.phi(:, 1) ~= 0) >= study.hypotheses.options.standsRuns - 1);
%! assert (batch.bits > 100);
%! assert (all (abs (batch.theta(:)) <= 1));
%! now.runs(1) = 9;
%! assert (proposed (study, state, now).bits < 1);
%!test
%! % of effects that are not parted the one with fewest runs first, at its mode
%! [study, state, now] = after (one, [5, 3, 9, 9, Inf]);
%! batch = proposed (study, state, setfield (now, 'rivals', [1, 2]));
%! assert ([batch.theta(1, :), batch.phi(1, 2)], ...
%!         study.fits.of{study.hypotheses.singles(2)}.Q(1:3), 1e-9);
%!test
%! % a likely pair is run, but not where runs of it gave no result
%! [study, state, now] = after (labOf ([0.6, 0, 0.5, 0, 0]), 9 * ones (1, 5));
%! pair = find (strcmp (now.evidence.kind, 'pair'));
%! [~, best] = max (now.verdict.P(pair));
%! members = now.evidence.members{pair(best)};
%! now.verdict.P = 0.01 + 0 * now.verdict.P;
%! now.verdict.P(pair(best)) = 0.5;
%! hasBoth = @(batch) any (all (batch.phi(:, members) ~= 0, 2));
%! assert (hasBoth (proposed (study, state, now)));
%! state.data.X(end + 1, :) = state.data.X(1, :);
%! phi = zeros (1, 5);
%! phi(members) = 0.5;
%! state.data.E(end + 1, :) = valuesOfStrength (study.problem.effects, phi);
%! state.data.Z(end + 1, :) = NaN;
%! state.data.replicate(end + 1) = 1;
%! assert (~hasBoth (proposed (study, state, now)));
%!test % an effect that is alone in the list
%! [study, state, now] = after (one, 1);
%! [now.usable, now.verdict.include] = deal (1, 0.96);
%! assert (proposed (study, state, now).bits > 100);

% SPDX-License-Identifier: GPL-3.0-only
