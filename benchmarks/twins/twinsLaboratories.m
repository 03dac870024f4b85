% TWINSLABORATORIES  Makes the laboratories of the twin study.
%
% CALL: LABS = twinsLaboratories (KIND, ROOT)
%
%   KIND  'blind' or 'develop': disjoint sets of laws; 'real': one laboratory,
%         the surrogates of real LIGGGHTS runs (data/hiddenEffect.csv, of the
%         benches Collapse, Shear and Heap). Its truth is drawn from the
%         surrogates with their own errors as noise, for want of another
%   ROOT  folder of the toolbox
%   LABS  1 x L struct: name, problem (of newGapProblem, y still NaN), data
%         (200 runs: 40 neutral, 20 for each of 8 effects), means (handle,
%         noiseless results of theta in [0, 1] and strengths), seedSd, em (of
%         fitEmulator), noise (1 x T: measurement, packing and surrogate),
%         direction (2 x T: signatures of causes that no list holds), isSigned
%         (1 x K, effects that act both ways), measure (handle, y = measure
%         (theta, phi): with noise, correlated by 0.2 within a bench)
%
% See also: standInGap, twinsDraw

function labs = twinsLaboratories (kind, root)
  if strcmp (kind, 'real')
    labs = realLaboratory (root);
    return
  end
  seeds = [21, 22, 23, 24];
  if strcmp (kind, 'develop')
    seeds = [11, 12];
  end
  for i = 1:numel (seeds)
    rand ('twister', 100 + seeds(i));
    randn ('twister', 100 + seeds(i));
    lab = standInGap (0.3, seeds(i));
    one = struct ('name', sprintf ('standIn%d', seeds(i)), ...
                  'problem', lab.problem, 'data', lab.plan (40, 20), ...
                  'means', lab.means, 'seedSd', lab.seedSd);
    bench = lab.problem.bench;
    given = lab.problem;
    given.y = ones (1, 24);
    problem = newGapProblem (given);
    one.em = fitEmulator (problem, one.data, gapOptions ([]));
    one.noise = sqrt (given.sd.^2 + lab.seedSd.^2 + ...
                      mean (one.em.surrogateVar, 1));
    one.direction = [2 * randn(1, 24); 3 * randn(1, 24) .* (bench == 2)];
    labs(i) = measuring (one);
  end
end

function lab = realLaboratory (root)
  [given, data] = storedCampaign ('hiddenEffect', root);
  problem = newGapProblem (given);
  em = fitEmulator (problem, data, gapOptions ([]));
  few = ~[em.effect.laboratory] & [em.effect.runs] < 6;
  full = em;
  em = withoutEffects (em, find (few));
  given.effects = given.effects(~few);
  given.held(:) = false;
  T = numel (given.y);
  lab = struct ('name', 'realBenches', 'problem', given, 'data', data, ...
                'means', @(theta, phi) surrogateMeans (em, theta, phi), ...
                'seedSd', sqrt (full.seedVar + mean (full.surrogateVar, 1)), ...
                'em', em);
  noise = diag (noiseBudget (problem, em).covariance)';
  lab.noise = sqrt (noise + mean (em.surrogateVar, 1));
  rand ('twister', 131);
  randn ('twister', 131);
  lab.direction = [1; 1] .* lab.noise .* randn (2, T);
  lab.direction(2, given.bench ~= 1) = 0;
  lab = measuring (lab);
end

function lab = measuring (lab)
  bench = lab.problem.bench;
  noise = sqrt (lab.problem.sd.^2 + lab.seedSd.^2);
  factor = chol (0.2 * (bench' == bench) + 0.8 * eye (numel (bench)));
  lab.isSigned = [lab.problem.effects.laboratory];
  lab.measure = @(theta, phi) lab.means (theta, phi) + ...
                noise .* (randn (1, numel (noise)) * factor);
end

function Z = surrogateMeans (em, theta, phi)
  h = find (phi);
  Z = predictGap (em, h, [2 * theta - 1, phi(h)]);
end
