% CALIBRATEVERDICT  Tries the verdict on data sets whose cause is known.
%
% CALL: [MODELS, EXPECTED] = calibrateVerdict (PROBLEM, EM, MODELS, OPTIONS)
%
%   PROBLEM, EM, MODELS  of newGapProblem, fitEmulator, makeModels
%   OPTIONS              of gapOptions (twins, seed, draws)
%   MODELS    the same with temperature and nameAt set
%   EXPECTED  struct: n (twins), temperature, nameAt, falseName (share of twins
%             without a gap that are named), right (share of single effects at
%             signal to noise above 4 that are named or grouped rightly), top1
%             (the likeliest effect is the true one, same twins), precision
%             (share of names that are right), wrongUnlisted (share named
%             although the true cause was taken off the list)
%
% The twins come from the user's own surrogates and targets: 30 % no gap, 45 %
% single effects, 25 % an effect that is then taken off the list. The
% temperature maximises the mean log probability of the truth (one parameter,
% Guo et al. 2017); nameAt is the smallest of 0.8, 0.85, 0.9, 0.95
% with at most 3 % names where none is right and 4 % wrong names, or the best.
%
% See also: judgeCase, drawTwins

function [models, expected] = calibrateVerdict (problem, em, models, options)
  expected = struct ('n', options.twins, 'temperature', ...
                     models.temperature, 'nameAt', models.nameAt, ...
                     'falseName', NaN, 'right', NaN, 'top1', NaN, ...
                     'precision', NaN, 'wrongUnlisted', NaN);
  K = numel (em.effect);
  if options.twins == 0 || K == 0
    return
  end
  before = {rand('twister'), randn('twister')};
  restore = onCleanup (@() putBack (before));
  rand ('twister', options.seed + 1000);
  randn ('twister', options.seed + 1000);
  fast = options;
  fast.draws = min (options.draws, 400);
  trials = runTwins (problem, em, fast, planTwins (options.twins, K));
  models.temperature = bestTemperature (trials);
  models.nameAt = bestThreshold (trials, models);
  expected = summarise (expected, trials, models);
end

function putBack (before)
  rand ('twister', before{1});
  randn ('twister', before{2});
end

% removed > 0: this effect is the cause and then missing from the list.
function plan = planTwins (n, K)
  nNull = round (0.3 * n);
  nOut = round (0.25 * n) * (K > 1);
  nSingle = n - nNull - nOut;
  plan.cause = [zeros(1, nNull), 1 + mod(0:nSingle - 1, K), ...
                1 + mod(0:nOut - 1, K)];
  plan.removed = [zeros(1, nNull + nSingle), 1 + mod(0:nOut - 1, K)];
  plan.d = 1 + 7 * rand (n, 1);
end

function trials = runTwins (problem, em, options, plan)
  full = makeModels (problem, em, options);
  trials = struct ('w', {}, 'models', {}, 'cause', {}, 'd', {});
  for removed = unique (plan.removed)
    at = find (plan.removed == removed);
    causes = num2cell (plan.cause(at));
    causes(plan.cause(at) == 0) = {[]};
    twins = drawTwins (full, causes, plan.d(at));
    models = full;
    cause = plan.cause(at);
    if removed > 0
      models = makeModels (problem, withoutEffects (em, removed), options);
      cause(:) = -1;
    end
    fits = fitLibrary (models, twins.Y);
    for i = 1:numel (at)
      w = weighCase (models, fits, i, false);
      w.posterior = [];
      trials(end + 1) = struct ('w', w, 'models', models, ...
                                'cause', cause(i), 'd', twins.d(i));
    end
  end
end

% Truth among the hypotheses: 1 null, 1 + k single, last unlisted.
function T = bestTemperature (trials)
  grid = [1, 1.2, 1.5, 2, 2.5, 3];
  score = zeros (size (grid));
  for g = 1:numel (grid)
    for i = 1:numel (trials)
      w = trials(i).w;
      logP = w.logPrior + w.logE / grid(g);
      logP = logP - logSumExp (logP);
      truth = 1 + trials(i).cause;
      if trials(i).cause < 0
        truth = numel (logP);
      end
      score(g) = score(g) + max (logP(truth), -12);
    end
  end
  [~, best] = max (score);
  T = grid(best);
end

function nameAt = bestThreshold (trials, models)
  cause = [trials.cause];
  grid = unique ([models.nameAt, max(models.nameAt, 0.85:0.05:0.95)]);
  excess = zeros (size (grid));
  for g = 1:numel (grid)
    models.nameAt = grid(g);
    s = verdicts (trials, models);
    wrong = s.named & ~s.right;
    listed = s.named & cause >= 0;
    excess(g) = max ([mean([wrong(cause <= 0), 0]) - 0.03, ...
                      sum(wrong & listed) / max(sum (listed), 1) - 0.04, 0]);
  end
  [~, best] = min (excess);
  nameAt = grid(best);
end

function s = verdicts (trials, models)
  n = numel (trials);
  s = struct ('named', false (1, n), 'right', false (1, n), ...
              'top', false (1, n));
  for i = 1:n
    own = trials(i).models;
    own.temperature = models.temperature;
    own.nameAt = models.nameAt;
    verdict = judgeCase (trials(i).w, own);
    s.named(i) = strcmp (verdict.kind, 'named');
    inside = ismember (trials(i).cause, verdict.effects);
    s.right(i) = inside && any (strcmp (verdict.kind, {'named', 'group'}));
    s.top(i) = verdict.top == trials(i).cause;
  end
end

function expected = summarise (expected, trials, models)
  s = verdicts (trials, models);
  cause = [trials.cause];
  strong = cause > 0 & [trials.d] >= 4;
  expected.temperature = models.temperature;
  expected.nameAt = models.nameAt;
  listed = s.named & cause >= 0;
  expected.falseName = share (s.named(cause == 0));
  expected.right = share (s.right(strong));
  expected.top1 = share (s.top(strong));
  expected.precision = share (s.right(listed));
  expected.wrongUnlisted = share (s.named(cause < 0));
end

% NaN where there is nothing to count.
function part = share (isSo)
  part = sum (isSo) / numel (isSo);
end
