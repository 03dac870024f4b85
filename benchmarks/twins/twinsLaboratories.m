% TWINSLABORATORIES  Makes the laboratories of the twin study.
%
% CALL: LABS = twinsLaboratories (KIND)
%
%   KIND  'blind' or 'develop': disjoint sets of laws
%   LABS  1 x L struct: name, gapProblem (value still NaN), data
%         (200 runs: 40 neutral, 20 for each of 8 effects), means (handle,
%         noiseless results of theta in [0, 1] and strengths), noiseSd, em (of
%         fitEmulator), noise (1 x T: measurement, packing and surrogate),
%         direction (2 x T: signatures of causes that no list holds), isSigned
%         (1 x K, effects that act both ways), measure (handle, y = measure
%         (theta, phi): with noise, correlated by 0.2 within a bench)
%
% See also: standInGap, twinsDraw

function labs = twinsLaboratories (kind)
  seeds = [21, 22, 23, 24];
  if strcmp (kind, 'develop')
    seeds = [11, 12];
  end
  for i = 1:numel (seeds)
    rand ('twister', 100 + seeds(i));
    randn ('twister', 100 + seeds(i));
    lab = standInGap (0.3, seeds(i));
    one = struct ('name', sprintf ('standIn%d', seeds(i)), ...
                  'gapProblem', lab.gapProblem, 'data', lab.plan (40, 20), ...
                  'means', lab.means, 'noiseSd', lab.noiseSd);
    bench = lab.gapProblem.bench;
    given = lab.gapProblem;
    given.value = ones (1, 24);
    gapProblem = newGapProblem (given);
    one.em = fitEmulator (gapProblem, one.data, gapOptions ([]));
    one.noise = sqrt (given.sd.^2 + lab.noiseSd.^2 + ...
                      mean (one.em.surrogateVar, 1));
    one.direction = [2 * randn(1, 24); 3 * randn(1, 24) .* (bench == 2)];
    labs(i) = measuring (one);
  end
end

function lab = measuring (lab)
  bench = lab.gapProblem.bench;
  noise = sqrt (lab.gapProblem.sd.^2 + lab.noiseSd.^2);
  factor = chol (0.2 * (bench' == bench) + 0.8 * eye (numel (bench)));
  lab.isSigned = [lab.gapProblem.effects.laboratory];
  lab.measure = @(theta, phi) lab.means (theta, phi) + ...
                noise .* (randn (1, numel (noise)) * factor);
end
