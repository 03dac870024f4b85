% YADEVSLIGGGHTS  Measures in what YADE and LIGGGHTS differ without an effect.
%
% CALL: yadeVsLiggghts (WORK)
%
% WORK  text, folder of the runs; finished ones that lie there are taken
%
% Three parameter sets and two packings on the benches Collapse and Heap, in
% both codes: 24 runs. Writes benchmarks/results/yadeVsLiggghts.csv, a row a
% run, and prints for each result and set the mean of LIGGGHTS, that of YADE,
% their difference in percent, and the difference in standard deviations of one
% run (pooled over sets and codes, 6 degrees of freedom).
%
% See also: yadeRuns
function yadeVsLiggghts (work)
  here = fileparts (mfilename ('fullpath'));
  out = fullfile (fileparts (fileparts (here)), 'results', ...
                  'yadeVsLiggghts.csv');
  plan = fullfile (work, 'plan.csv');
  [~, ~] = mkdir (work);
  writeAtomic (plan, planOf ());
  table = yadeRuns (plan, out, work);
  header = table(1, :);
  body = table(2:end, :);
  column = @(name) body(:, strcmp (header, name));
  isYade = strcmp (column ('code'), 'yade');
  set = findgroupsOf (column ('coefFrictionPP'));
  printf ('| result | set | LIGGGHTS | YADE | difference | / sd |\n');
  printf ('|---|---|---|---|---|---|\n');
  for name = header(find (strcmp (header, 'seconds')) + 1:end)
    value = str2double (column (name{1}));
    sayResult (name{1}, value, set, isYade);
  end
  seconds = str2double (column ('seconds'));
  for bench = {'Collapse', 'Heap'}
    at = strcmp (column ('model'), bench{1});
    printf ('%s: CPU time of a run %.1f s (LIGGGHTS), %.1f s (YADE)\n', ...
            bench{1}, mean (seconds(at & ~isYade)), ...
            mean (seconds(at & isYade)));
  end
end

% densities, frictions (grains, walls), rolling friction (YADE has one)
function text = planOf ()
  sets = [1200, 0.5, 0.5, 0.05; 1080, 0.3, 0.4, 0.02; 1320, 0.7, 0.6, 0.15];
  text = sprintf (['code,model,seed,densityP,coefFrictionPP,' ...
                   'coefFrictionPW,coefRollingFrictionPP,' ...
                   'coefRollingFrictionPW\n']);
  seeds = benchSeeds (1:2);
  [at, s, bench, code] = ndgrid (1:2, 1:3, 1:2, 1:2);
  codes = {'liggghts', 'yade'};
  benches = {'Collapse', 'Heap'};
  for k = 1:numel (at)
    text = [text, sprintf('%s,%s,%d,%g,%g,%g,%g,%g\n', codes{code(k)}, ...
                          benches{bench(k)}, seeds(at(k)), ...
                          sets(s(k), :), sets(s(k), 4))];
  end
end

function set = findgroupsOf (texts)
  [~, first, set] = unique (texts, 'first');
  [~, order] = sort (first);
  [~, place] = sort (order);
  set = place(set);
end

function sayResult (name, value, set, isYade)
  known = isfinite (value);
  scatter = [];
  means = NaN (max (set), 2);
  for s = 1:max (set)
    for code = 0:1
      own = value(known & set == s & isYade == code);
      means(s, code + 1) = mean (own);
      scatter = [scatter; own - mean(own)];
    end
  end
  sd = sqrt (sum (scatter.^2) / (numel (scatter) / 2));
  for s = 1:max (set)
    gap = means(s, 2) - means(s, 1);
    printf ('| %s | %d | %.4g | %.4g | %+.1f %% | %+.1f |\n', name, s, ...
            means(s, :), 100 * gap / abs (means(s, 1)), gap / sd);
  end
end
