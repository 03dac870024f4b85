% MAKEMODELS  Prepares all hypotheses of a diagnosis for fast evaluation.
%
% CALL: MODELS = makeModels (PROBLEM, EM, OPTIONS, TARGETS)
%
%   PROBLEM  struct of newGapProblem
%   EM       struct of fitEmulator; its effects are the library
%   OPTIONS  struct of gapOptions
%   TARGETS  1 x n, targets to use (default PROBLEM.used)
%   MODELS   struct
%     white     whitened emulator of the targets
%     prior     mean, precision (1 x p), widen
%     kinds     1 x m struct of the unlisted causes (unlistedKinds)
%     weights   prior probabilities: null, single (all singles together), pair,
%               unlisted
%     base      points of integrationPoints, and noise (1000 x n)
%     starts    s x p, starts of the null fit
%     names, siblings, nameAt, level, temperature
%
% See also: fitLibrary, weighCase, judgeCase

function models = makeModels (problem, em, options, targets)
  if nargin < 4
    targets = problem.used;
  end
  budget = noiseBudget (problem, em);
  models.white = whitenEmulator (em, targets, budget.covariance);
  models.prior = parameterPrior (problem);
  models.kinds = unlistedKinds (problem, em, budget, models.white);
  models.weights = struct ('null', 0.4, 'single', 0.4, 'pair', 0.1, ...
                           'unlisted', 0.1);
  d = em.p + 2;
  models.base = integrationPoints (options.draws, d, options.seed);
  models.noise = integrationPoints (1000, numel (targets), ...
                                    options.seed).normal;
  spread = integrationPoints (11, em.p, options.seed);
  models.starts = [zeros(1, em.p); 2 * spread.uniform - 1];
  models.names = {em.effect.name};
  models.siblings = siblingsOf (problem, models.names);
  models.nameAt = options.nameAt;
  models.level = options.level;
  models.temperature = options.temperature;
end

function prior = parameterPrior (problem)
  half = diff (problem.limits) / 2;
  prior.mean = (problem.paramMean - mean (problem.limits)) ./ half;
  prior.precision = (half ./ problem.paramSd).^2;
  without = ~isfinite (prior.mean) | ~isfinite (prior.precision);
  prior.mean(without) = 0;
  prior.precision(without) = 0;
  prior.widen = 1;
end

function siblings = siblingsOf (problem, names)
  siblings = cell (1, numel (names));
  for k = 1:numel (names)
    at = find (strcmp ({problem.effects.name}, names{k}), 1);
    siblings{k} = setdiff (problem.effects(at).siblings(:)', names);
  end
end

%!test
%! % a measured parameter becomes a normal prior in scaled units
%! lab = standInGap (0);
%! keep = 1:6;
%! given = struct ('y', ones (1, 6), 'sd', lab.seedSd(keep), ...
%!                 'limits', lab.problem.limits, 'bench', ones (1, 6), ...
%!                 'paramMean', [0.75, NaN, NaN, NaN], ...
%!                 'paramSd', [0.05, NaN, NaN, NaN]);
%! rand ('twister', 1); randn ('twister', 1);
%! data = lab.plan (14, 0);
%! data.Z = data.Z(:, keep);
%! data.E = zeros (14, 0);
%! problem = newGapProblem (given);
%! options = gapOptions (struct ('trend', 'affine', 'draws', 100));
%! em = fitEmulator (problem, data, options);
%! models = makeModels (problem, em, options);
%! assert (models.prior.mean, [0.5, 0, 0, 0], 1e-12);
%! assert (models.prior.precision, [100, 0, 0, 0], 1e-9);
%! assert (size (models.base.normal), [100, 6]);
