% LEVELEFFECTS  Effects learned with coarse runs and a few fine ones.
%
% CALL: octave-cli benchmarks/levelEffects.m SEEDS [CSV]
%
% SEEDS  numbers of the laboratories (standInGap, curvature 0.3), as 1:20
%
% Each laboratory has a coarse level whose law is another one: the results are
% off by a plane in the parameters of the size of their range / 5, and what each
% effect does on each bench is multiplied by exp (0.3 N (0, 1)) at the level
% that counts. One effect in four cases of five, at a strength from 0.4 to 1.
% Three diagnoses, without new runs:
%   coarse  30 runs without and 5 with each effect, all coarse
%   both    the same, and 9 runs without and one with each effect that are fine
%   fine    30 and 5, all fine
% One CSV row a laboratory and diagnosis: truth, d (what of the effect
% parameters cannot take, in standard deviations), verdict, effects, whether the
% truth is among them (or nothing is, where there is none).
%
% See also: standInGap, learnEffect

1;

function [given, runs, truth, gap] = caseOf (seed)
  lab = standInGap (0.3, seed);
  rand ('twister', 1000 + seed);
  randn ('twister', 1000 + seed);
  given = lab.gapProblem;
  truth = 0;
  phi = zeros (1, 10);
  if rand () < 0.8
    truth = randi (8);
    phi(truth) = 0.4 + 0.6 * rand ();
  end
  theta = 0.2 + 0.6 * rand (1, 4);
  noise = sqrt (2) * lab.noiseSd;
  given.value = lab.means (theta, phi) + noise .* randn (1, 24);
  neutral = lab.means (theta, zeros (1, 10));
  gap = (lab.means (theta, phi) - neutral) ./ noise;
  near = lab.means (theta + full (1e-3 * eye (4)), zeros (4, 10));
  slopes = (near - neutral) ./ noise;
  gap = norm (gap - (gap / slopes) * slopes);
  % a gain for each effect and bench, a plane for each result
  gain = exp (0.3 * randn (8, 4))(:, given.bench);
  plane = 0.6 * randn (5, 24);
  fine = lab.plan (39, 6);
  coarse = lab.plan (30, 5);
  coarse.Z = coarsened (lab, coarse, gain, plane);
  given.coarse = struct ('levels', [1; 0], 'column', ones (1, 24));
  first = [(1:9)'; 39 + 6 * (1:8)'];
  some = keepRows (fine, first);
  runs.coarse = coarse;
  runs.both = struct ();
  for name = fieldnames (coarse)'
    runs.both.(name{1}) = [coarse.(name{1}); some.(name{1})];
  end
  runs.both.level = [ones(rows (coarse.X), 24); zeros(rows (some.X), 24)];
  runs.fine = keepRows (fine, setdiff (1:rows (fine.X), first));
end

function Z = coarsened (lab, data, gain, plane)
  n = rows (data.X);
  none = zeros (n, 10);
  neutral = lab.means (data.X, none);
  Z = neutral + [ones(n, 1), 2 * data.X - 1] * plane;
  with = lab.means (data.X, [data.E, zeros(n, 2)]) - neutral;
  for i = find (any (data.E > 0, 2))'
    with(i, :) = with(i, :) ./ gain(find (data.E(i, :) > 0), :);
  end
  Z = Z + with + lab.noiseSd .* randn (n, 24);
end

here = fileparts (mfilename ('fullpath'));
addpath (here);
startBenchmarks ();
words = argv ();
out = stdout;
if numel (words) > 1
  out = fopen (words{2}, 'w');
end
fprintf (out, 'seed,runs,truth,d,verdict,effects,right\n');
for seed = str2num (words{1})
  [given, runs, truth, gap] = caseOf (seed);
  names = {given.effects.name, 'none'};
  names = names([end, 1:end - 1]);
  for kind = fieldnames (runs)'
    d = diagnoseMatrices (given, runs.(kind{1}), ...
                          struct ('bootstrap', 49));
    found = d.which.effects;
    right = any (strcmp (names{truth + 1}, found)) || ...
            (truth == 0 && isempty (found));
    fprintf (out, '%d,%s,%s,%.1f,%s,%s,%d\n', seed, kind{1}, ...
             names{truth + 1}, gap, d.which.verdict, ...
             strjoin (found, ' '), right);
    fflush (out);
  end
end
