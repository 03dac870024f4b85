% COARSERUNS  What runs at coarser levels save, and that they do no harm.
%
% CALL: octave-cli benchmarks/coarseRuns.m KIND SEEDS [CSVFILE]
%
% KIND   'alike': the coarse level is off by 5 % and bent a little; 'biased': by
%        15 %, and bent; 'useless': another function altogether; 'stored': as
%        'alike', and 40 runs of level 4 over the box are there already (another
%        case made them with larger grains; here they cost nothing)
% SEEDS  e.g. 1:100
%
% Each seed calibrates the stand-in 'plain' twice: with runs at the level that
% counts alone, and with the levels 4, 3 and 2. A run at level s costs (2 / s)^4
% (grains fewer by the cube, time step longer) and scatters by (s / 2)^1.5 as
% much as one at level 2. One CSV row a seed: seed, then for both ways cost (in
% runs at level 2), runs, worst (true relative residual), probability,
% converged. Then the ratio of the costs with an interval (bootstrap of the
% seeds).
%
% See also: calibrateStandIn, improveByInfill

1;

function S = levelled (kind)
  S = standIn ('plain');
  S.levels = [4; 3; 2];
  S.seconds = (2 ./ S.levels').^4;
  unit = @(E) (E - 2) / 2;
  u = @(P) (P - S.limits(1, :)) ./ diff (S.limits);
  switch kind
    case {'alike', 'stored'}
      S.atLevel = @(P, E) bent (S, P, u (P), unit (E), 0.05);
    case 'biased'
      S.atLevel = @(P, E) bent (S, P, u (P), unit (E), 0.15);
    case 'useless'
      S.atLevel = @(P, E) other (S, P, u (P), unit (E));
  end
  if strcmp (kind, 'stored')
    rand ('twister', 7);
    randn ('twister', 7);
    P = S.limits(1, :) + rand (40, 5) .* diff (S.limits);
    Z = S.atLevel (P, 4 * ones (40, 1)) .* (1 + S.noise * randn (40, 2));
    S.library = addRows (newData (5, 2, 1), P, Z, ones (40, 1), 'library', ...
                         4 * ones (40, 1));
  end
end

% Off by SHARE on the average, more where the first two parameters are large,
% and not in proportion to the level.
function Z = bent (S, P, U, level, share)
  off = share * level.^1.5 .* [0.5 + U(:, 1), 1.5 - U(:, 2).^2];
  Z = S.response (P) .* (1 + off) .* noiseOf (S, level);
end

function Z = other (S, P, U, level)
  wild = S.value .* (1 + 0.3 * [sin(7 * U(:, 3) + 2 * U(:, 1)), ...
                                cos(6 * U(:, 4) - 3 * U(:, 2))]);
  Z = merge (level > 0 & true (1, 2), wild, S.response (P)) .* ...
      noiseOf (S, level);
end

% The scatter beyond that of a run at the last level, which noisy adds.
function factor = noiseOf (S, level)
  beyond = sqrt ((1 + level).^3 - 1);
  factor = 1 + S.noise .* beyond .* randn (rows (level), 2);
end

function row = rowOf (S, seed)
  r = calibrateStandIn (S, seed, 0, struct ());
  row = [r.cost, r.runs, r.worst, r.probability, r.converged];
end

function sayKind (kind, R)
  ratio = sum (R(:, 7)) / sum (R(:, 2));
  boot = zeros (1, 2000);
  for b = 1:2000
    pick = ceil (rows (R) * rand (rows (R), 1));
    boot(b) = sum (R(pick, 7)) / sum (R(pick, 2));
  end
  printf (['%s, %d seeds: cost with levels %.2f of the cost without (95 %% ' ...
           '%.2f to %.2f), median %.1f against %.1f runs; sets truly ' ...
           'within 1 %%: %d and %d; stated probability %.2f and %.2f\n'], ...
          kind, rows (R), ratio, quantile (boot', [0.025; 0.975]), ...
          median (R(:, 7)), median (R(:, 2)), sum (R(:, 9) < 0.01), ...
          sum (R(:, 4) < 0.01), mean (R(:, 10)), mean (R(:, 5)));
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
given = argv ();
with = levelled (given{1});
without = standIn ('plain');
seeds = sscanf (given{2}, '%d:%d')';
R = [];
for seed = seeds(1):seeds(end)
  R(end + 1, :) = [seed, rowOf(without, seed), rowOf(with, seed)];
  printf ('%4d  %5.1f %5.1f  worst %.2f %.2f %%\n', seed, R(end, [2, 7]), ...
          100 * R(end, [4, 9]));
end
sayKind (given{1}, R);
if numel (given) > 2
  writeMatrix (given{3}, R, {'seed', 'cost', 'runs', 'worst', 'probability', ...
                             'converged', 'costLevels', 'runsLevels', ...
                             'worstLevels', 'probabilityLevels', ...
                             'convergedLevels'});
end
