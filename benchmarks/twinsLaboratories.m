% TWINSLABORATORIES  Makes the laboratories of the twin study.
%
% CALL: LABS = twinsLaboratories (KIND, ROOT)
%
%   KIND  'blind' or 'develop': disjoint sets of laws
%   ROOT  folder of the toolbox
%   LABS  1 x L struct: name, problem (of newGapProblem, y still NaN), data
%         (200 runs: 40 neutral, 20 for each of 8 effects), means (handle,
%         noiseless results of theta in [0, 1] and strengths), seedSd, em (of
%         fitEmulator), noise (1 x T: measurement, packing and surrogate),
%         direction (2 x T: signatures of causes that no list holds)
%
% See also: standInGap, twinsDraw

function labs = twinsLaboratories (kind, root)
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
    labs(i) = one;
  end
end
