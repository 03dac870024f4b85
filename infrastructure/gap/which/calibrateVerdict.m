% CALIBRATEVERDICT  Tries the verdict on data sets whose cause is known.
%
% CALL: EXPECTED = calibrateVerdict (STUDY)
%
%   STUDY     struct gapProblem, em, models: of newGapProblem, fitEmulator,
%             makeHypotheses with its reference (omnibusReference)
%   EXPECTED  struct: n (data sets, models.options.trials), falseName (share of
%             those without a gap that are named), right (share of single
%             effects at signal to noise above 4 that are named or grouped
%             rightly), top1 (the likeliest effect is the true one, same data
%             sets), precision (share of names that are right), wrongUnlisted
%             (share named although the true cause was taken off the list)
%
% 30 % no gap, 45 % single effects, 25 % an effect that is then taken off the
% list, drawn from the user's own surrogates and targets and judged by Laplace's
% formula. They come from the model of inference itself: what they say is how
% well the best could do with these targets; benchmarks/leftOut.m and
% benchmarks/foreignTwins.m say what is left of it on other data.

function expected = calibrateVerdict (study)
  models = study.models;
  n = models.options.trials;
  expected = struct ('n', n, 'falseName', NaN, 'right', NaN, 'top1', NaN, ...
                     'precision', NaN, 'wrongUnlisted', NaN);
  K = numel (study.em.effect);
  if n == 0 || K == 0
    return
  end
  plan = planTwins (n, K, models.options.seed);
  causes = num2cell (plan.cause);
  causes(plan.cause == 0) = {zeros(1, 0)};
  twins = drawTwins (models, causes, plan.d, models.options.seed + 1000);
  fits = fitLibrary (models, twins.Y);
  s = struct ('named', [], 'right', [], 'top', [], 'cause', [], 'd', []);
  for removed = unique (plan.removed)
    at = find (plan.removed == removed);
    own = models;
    left = fits;
    cause = plan.cause(at);
    if removed > 0
      own = modelsWithout (study, removed);
      left = withoutFits (own, fits, twins.Y, at, removed, models);
      cause(:) = -1;
    end
    s = addTrials (s, own, left, at, cause, twins.d);
  end
  strong = s.cause > 0 & s.d >= 4;
  expected.falseName = share (s.named(s.cause == 0));
  expected.right = share (s.right(strong));
  expected.top1 = share (s.top(strong));
  expected.precision = share (s.right(s.named & s.cause >= 0));
  expected.wrongUnlisted = share (s.named(s.cause < 0));
end

% Twins have no pair, so what pairs do together is left out.
function models = modelsWithout (study, removed)
  em = withoutEffects (study.em, removed);
  em.joint = em.joint([]);
  models = makeHypotheses (study.gapProblem, em, study.models.options);
  models.reference = study.models.reference;
end

% removed > 0: this effect is the cause and then missing from the list.
function plan = planTwins (n, K, seed)
  nNull = round (0.3 * n);
  nOut = round (0.25 * n) * (K > 1);
  nSingle = n - nNull - nOut;
  plan.cause = [zeros(1, nNull), 1 + mod(0:nSingle - 1, K), ...
                1 + mod(0:nOut - 1, K)];
  plan.removed = [zeros(1, nNull + nSingle), 1 + mod(0:nOut - 1, K)];
  plan.d = 1 + 7 * integrationPoints (n, 1, seed + 1000).uniform;
end

function s = addTrials (s, models, fits, at, cause, d)
  for j = 1:numel (at)
    i = at(j);
    verdict = judgeCase (laplaceCase (models, fits, i), models);
    isSaid = any (strcmp (verdict.kind, {'named', 'group'}));
    s.named(end + 1) = strcmp (verdict.kind, 'named');
    s.right(end + 1) = isSaid && ismember (cause(j), verdict.effects);
    s.top(end + 1) = verdict.top == cause(j);
    s.cause(end + 1) = cause(j);
    s.d(end + 1) = d(i);
  end
end

% Fits without effect K. Of the misfits only the last one, shaped like the
% listed effects, is another one then.
function fits = withoutFits (models, fits, Y, at, k, whole)
  hypotheses = [whole.list.h];
  holds = cellfun (@(m) any (m == k), {hypotheses.members});
  fits.of(holds) = [];
  fits.logE(:, holds) = [];
  row = models.list(end);
  U = [fits.of{row.from}.U(at, :), repmat(row.starts, numel (at), 1)];
  fit = fitHypothesis (row.white, row.h, Y(at, :) * row.white.W', U, ...
                       models.prior);
  fits.logE(at, end) = fit.logE;
end

% What caseEvidence gives, without pairs and without integration.
function w = laplaceCase (models, fits, i)
  hypotheses = [models.list.h];
  w = struct ('kind', {{hypotheses.kind}}, ...
              'members', {{hypotheses.members}}, ...
              'logPrior', log ([models.list.prior]), ...
              'logE', fits.logE(i, :), 'ess', NaN, ...
              'gate', omnibusTest (models, fits.logE(i, :)));
  if w.gate.p < models.options.level
    w.screen = screenEffects (models.white, fits.calibrated.Q(i, :));
  end
  [w.atLimit, w.alike] = deal (zeros (size (w.logE)));
  w.phi = NaN (size (w.logE));
  % of a sibling its mode
  for j = find (strcmp (w.kind, 'sibling'))
    w.alike(j) = fits.of{j}.Q(i, end) <= models.options.lookAlike(1);
  end
  for j = models.singles
    w.phi(j) = fits.of{j}.Q(i, models.white.p + 1);
    w.alike(j) = 1;
  end
  % whether it is this very effect is not tried
  [w.top, w.exclude] = deal ([], 0);
end

% NaN where there is nothing to count.
function part = share (isSo)
  part = sum (isSo) / numel (isSo);
end

%!test
%! % a library of two clear effects: mostly right (seeded)
%! rand ('twister', 4); randn ('twister', 4);
%! lab = standInGap (0);
%! given = setfield (lab.gapProblem, 'value', ones (1, 24));
%! data = lab.plan (40, 15);
%! few = [4, 5, 7];
%! given.effects = given.effects(few);
%! left = all (data.E(:, setdiff (1:8, few)) == 0, 2);
%! data = structfun (@(A) A(left, :), data, 'UniformOutput', false);
%! data.E = data.E(:, few);
%! study = labStudy (given, data, struct ('trials', 60, 'twins', 99));
%! study.models = omnibusReference (study.models);
%! expected = calibrateVerdict (study);
%! assert (expected.top1 > 0.8);
%! assert (expected.falseName < 0.1);
%! assert (calibrateVerdict (study).right, expected.right);
