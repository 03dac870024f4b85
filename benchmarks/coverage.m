% COVERAGE  Do the 90 % intervals hold the truth, are weak parameters named?
%
% CALL: octave-cli benchmarks/coverage.m SEEDS STANDIN [CSVFILE]
% CALL: octave-cli benchmarks/coverage.m report CSVFILE...
%
% SEEDS  e.g. 1:100, a calibration each; STANDIN  plain, rough or both
%
% The truth of each calibration is drawn from the box, flat as the prior; the
% targets are one noisy run at the truth (1 %). After the calibration (as in
% peers.m) parameterPosterior gives the intervals. What could be known at all is
% computed the same way from surrogates of 150 runs without noise: a parameter
% is identifiable where that reference interval is narrower than 40 % of the
% box, unidentifiable where it is wider than 60 %; in between nothing is asked.
%
% CSV: a row a parameter of a calibration: stand-in (1 plain, 2 rough), seed,
% parameter, truth, low, high (box widths), flagged, reference width.
%
% See also: calibrateStandIn, parameterPosterior

1;

function reference = referenceSurrogates (S)
  d = numel (S.names);
  X = double (stk_sampling_halton_rr2 (150, d, S.limits));
  Z = S.response (X);
  for t = 1:columns (Z)
    reference(t) = fitSurrogate (X, Z(:, t), S.limits);
  end
end

function block = oneCase (S, reference, which, seed)
  rand ('twister', 1e6 + seed);
  randn ('twister', 1e6 + seed);
  d = numel (S.names);
  width = diff (S.limits);
  truth = rand (1, d);
  z = S.response (S.limits(1, :) + truth .* width);
  S.value = z .* (1 + S.noise * randn (size (z)));
  r = calibrateStandIn (S, seed, 0, struct ());
  known = parameterPosterior (r.state.surrogates, r.problem);
  for t = 1:numel (reference)
    reference(t).noiseVar = (S.noise * S.value(t))^2;
  end
  best = parameterPosterior (reference, r.problem, 500);
  unit = @(I) ((I - S.limits(1, :)) ./ width)';
  block = [repmat([which, seed], d, 1), (1:d)', truth', ...
           unit(known.interval90), ~known.identified', ...
           (diff (best.interval90) ./ width)'];
end

function sayCoverage (B)
  hit = B(:, 4) >= B(:, 5) & B(:, 4) <= B(:, 6);
  can = B(:, 8) < 0.4;
  cannot = B(:, 8) > 0.6;
  printf ('| | parameters | in the 90 %% interval | flagged weak |\n');
  printf ('|---|---|---|---|\n');
  names = {'plain', 'rough', 'both'};
  for k = 1:3
    use = B(:, 1) == k | k == 3;
    sayLine (names{k}, 'identifiable', hit, B(:, 7), use & can);
    sayLine (names{k}, 'unidentifiable', hit, B(:, 7), use & cannot);
    sayLine (names{k}, 'all', hit, B(:, 7), use);
  end
end

function sayLine (name, kind, hit, flagged, use)
  printf ('| %s, %s | %d | %.1f %% | %.1f %% |\n', name, kind, sum (use), ...
          100 * mean (hit(use)), 100 * mean (flagged(use)));
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
given = argv ();
B = zeros (0, 8);
if strcmp (given{1}, 'report')
  for k = 2:numel (given)
    B = [B; csvread(given{k})];
  end
else
  seeds = sscanf (given{1}, '%d:%d');
  names = {'plain', 'rough'};
  for k = find (strcmp (names, given{2}) | strcmp ('both', given{2}))
    S = standIn (names{k});
    reference = referenceSurrogates (S);
    for seed = seeds(1):seeds(end)
      B = [B; oneCase(S, reference, k, seed)];
    end
  end
  if numel (given) > 2
    csvwrite (given{3}, B, 'precision', '%.10g');
  end
end
sayCoverage (B);
