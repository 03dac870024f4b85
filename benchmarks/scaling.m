% SCALING  Time and memory of fits and predictions by runs and targets.
%
% CALL: octave-cli benchmarks/scaling.m [CSVFILE]
%
% Prints three tables: fit, single call and batch of one surrogate for 50 to
% 2000 runs of 6 parameters; the same for 1 to 100 targets at 100 runs; and
% everything that DEcalioc does around the DEM for 20 targets, 6 parameters and
% 300 runs. Processor time (one thread), so that other programs do not count.
% CSV: runs, targets, fit s, single call s, batch s a point, MB.
%
% See also: fitSurrogates, predictSurrogate

1;

function [problem, data] = scaledCase (n, d, T)
  rand ('twister', n + T);
  randn ('twister', n + T);
  limits = [zeros(1, d); ones(1, d)];
  X = rand (n, d);
  A = rand (d, T);
  f = @(X) 5 + X * A + sin (3 * X(:, 1)) .* X(:, 2);
  value = f (0.5 * ones (1, d));
  Z = f (X) .* (1 + 0.01 * randn (n, T));
  Case.names = arrayfun (@(j) sprintf ('p%d', j), 1:d, ...
                         'UniformOutput', false);
  Case.limits = limits;
  Case.targets = struct ('value', num2cell (value), 'tol', 0.01);
  problem = newProblem (Case, []);
  data = addRows (newData (d, T), X, Z, ones (n, 1), 'plan');
end

function row = measure (n, T)
  [problem, data] = scaledCase (n, 6, T);
  start = cputime ();
  s = fitSurrogates (data, problem);
  fit = cputime () - start;
  start = cputime ();
  for i = 1:20
    predictSurrogate (s, data.X(1, :));
  end
  one = (cputime () - start) / 20;
  P = rand (1000, 6);
  start = cputime ();
  [~, ~] = predictSurrogate (s, P);
  batch = (cputime () - start) / 1000;
  row = [n, T, fit, one, batch, sizeof(struct2cell (s)) / 2^20];
  printf ('| %d | %d | %.2f s | %.2f ms | %.4f ms | %.1f MB |\n', n, T, ...
          fit, 1e3 * one, 1e3 * batch, row(end));
end

function total = measureAll ()
  [problem, data] = scaledCase (300, 6, 20);
  start = cputime ();
  double (stk_sampling_maximinlhs (300, 6, problem.limits, 100));
  at = cputime () - start;
  s = fitSurrogates (data, problem);
  at(end + 1) = cputime () - start;
  found = calibrateOnKriging (s, problem);
  at(end + 1) = cputime () - start;
  state = newState (data, s, found);
  state = runRows (state, problem, @(P, r) predictSurrogate (s, P), ...
                   repmat (found.params, 5, 1), 'verify');
  state.found = calibrateOnKriging (state.surrogates, problem);
  confirmSet (state, problem);
  at(end + 1) = cputime () - start;
  known = parameterPosterior (state.surrogates, problem);
  identifiability (state.surrogates, problem, known);
  at(end + 1) = cputime () - start;
  sobolIndices (state.surrogates, problem);
  at(end + 1) = cputime () - start;
  names = {'plan', 'fits', 'LM on Kriging', 'refit, LM, confirmation', ...
           'posterior', 'Sobol'};
  printf ('| part | s |\n|---|---|\n');
  steps = diff ([0, at]);
  for i = 1:numel (at)
    printf ('| %s | %.1f |\n', names{i}, steps(i));
  end
  total = at(end);
  printf ('| all | %.1f |\n', total);
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
printf ('| runs | targets | fit | one call | a point of a batch | memory |\n');
printf ('|---|---|---|---|---|---|\n');
R = zeros (0, 6);
for n = [50, 100, 200, 500, 1000, 2000]
  R(end + 1, :) = measure (n, 1);
end
for T = [10, 30, 100]
  R(end + 1, :) = measure (100, T);
end
measureAll ();
given = argv ();
if ~isempty (given)
  csvwrite (given{1}, R, 'precision', '%.6g');
end
