% MANYEFFECTS  Does a long list of candidates cost runs, or the right answer?
%
% CALL: octave-cli benchmarks/manyEffects.m [cases]
%
% Whole diagnoses, plan and new runs within the budget that gapBudget foresees,
% on a laboratory of formulas (4 parameters, 24 targets, 4 benches) with 10 and
% with 20 candidate effects; the same cause among the first ten, of strength 0.4
% to 1, and the same noise. Writes results/manyEffects.csv: case, effects on the
% list, sets in all (30 neutral ones among them), cause, likeliest effect, its
% probability with that of what resembles it, verdict, effects named.
%
% See also: gapBudget, diagnoseMatrices

1;

function lab = listLab (K)
  rand ('twister', 71);
  randn ('twister', 71);
  slope = 2 * randn (4, 24);
  bend = 0.3 * randn (4, 24);
  effect = 1.6 * randn (20, 24) .* (rand (20, 24) < 0.6);
  effect = effect(1:K, :);
  lab.means = @(X, phi) 15 + (2 * X - 1) * slope + (2 * X - 1).^2 * bend + ...
                        phi.^0.8 * effect;
  for k = 1:K
    name = sprintf ('effect%d', k);
    effects(k) = struct ('name', name, 'variables', {{name}}, 'neutral', 0, ...
                         'limits', [0.1; 1], 'laboratory', false);
  end
  lab.given = struct ('sd', 0.25 * ones (1, 24), 'effects', effects, ...
                      'limits', [zeros(1, 4); ones(1, 4)], ...
                      'bench', kron (1:4, ones (1, 6)));
  lab.data = struct ('X', double (stk_sampling_halton_rr2 (30, 4)), ...
                     'E', zeros (30, K), 'replicate', ones (30, 1));
  lab.data.Z = lab.means (lab.data.X, lab.data.E) + 0.25 * randn (30, 24);
end

function line = oneCase (number, K)
  pkg ('load', 'stk');
  lab = listLab (K);
  rand ('twister', 900 + number);
  randn ('twister', 900 + number);
  cause = randi (10);
  phi = zeros (1, K);
  phi(cause) = 0.4 + 0.6 * rand ();
  given = lab.given;
  given.value = lab.means (0.1 + 0.8 * rand (1, 4), phi) + 0.35 * randn (1, 24);
  Case.options.seed = number;
  Case.names = {'a', 'b', 'c', 'd'};
  options = gapBudget (Case, struct ('left', Inf, 'perSet', 1), given, NaN);
  options.twins = 200;
  options.trials = 0;
  options.bootstrap = 99;
  runs = @(X, E, replicate) lab.means (X, E) + 0.25 * randn (rows (X), 24);
  d = diagnoseMatrices (given, lab.data, options, runs);
  total = cellfun (@(n) d.which.posterior.(n) + d.which.resembles.(n), ...
                   {given.effects.name});
  [p, top] = max (total);
  line = sprintf ('%d,%d,%d,%d,%d,%.3f,%s,%s', number, K, 30 + d.runs.spent, ...
                  cause, top, p, d.which.verdict, ...
                  strjoin (d.which.effects, ' '));
end

function runAll (n)
  addpath (fileparts (mfilename ('fullpath')));
  root = startBenchmarks ();
  lines = {'case,effects,sets,cause,top,probability,verdict,named'};
  for K = [10, 20]
    right = 0;
    most = 0;
    for i = 1:n
      lines{end + 1} = oneCase (i, K);
      printf ('%s\n', lines{end});
      values = sscanf (lines{end}, '%d,%d,%d,%d,%d');
      right = right + (values(4) == values(5));
      most = max (most, values(3));
    end
    printf (['%d effects: the likeliest is right in %d of %d, %d sets at ' ...
             'most\n'], K, right, n, most);
  end
  writeAtomic (fullfile (root, 'benchmarks', 'results', 'manyEffects.csv'), ...
               [strjoin(lines, "\n"), "\n"]);
end

n = 6;
if numel (argv ()) > 0
  n = str2double (argv (){1});
end
runAll (n);
