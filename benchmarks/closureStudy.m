% CLOSURESTUDY  Does the right cause close the whole gap, and a placebo c^2?
%
% CALL: octave-cli benchmarks/closureStudy.m [CASES]
%
% CASES  of each laboratory and each signal to noise (60)
%
% Two laboratories: one linear with normal noise, whose surrogates are exact (14
% targets, 4 parameters, 6 effects), and one of foreign laws (foreignLab,
% 'develop' 1: thresholds, heavy tails; surrogates learned from 40 neutral runs
% and 20 of each effect). In each case one effect is on, with a
% signal to noise (twinsDraw) of 4, 6 or 9, and the diagnosis is told which; the
% null model, it and two placebos are fitted and run with five seeds, and
% measured (measureCure). Truth of the closure: 1.
%
% Writes results/closure.csv (every case) and prints: median closure, share of
% the 90 % intervals that hold 1, the same for the paired difference and 1 - c^2
% of each placebo, and how often a placebo counts against the right cause.
%
% See also: measureCure, closureOf, twinsDraw

1;

function runClosures (n)
  addpath (fileparts (mfilename ('fullpath')));
  root = startBenchmarks ();
  pkg ('load', 'stk');
  cases = {};
  for lab = {linearLab(), foreignOne()}
    for level = [4, 6, 9]
      cases = [cases, casesOf(lab{1}, level, n)];
    end
  end
  cases = [cases{:}];
  writeCases (fullfile (root, 'benchmarks', 'results', 'closure.csv'), cases);
  for name = unique ({cases.lab})
    for level = [4, 6, 9]
      at = strcmp ({cases.lab}, name{1}) & [cases.level] == level;
      if any (at)
        sayCases (name{1}, level, cases(at));
      end
    end
  end
end

function lab = linearLab ()
  rand ('twister', 31);
  randn ('twister', 31);
  [T, p, K] = deal (14, 4, 6);
  S = 4 * randn (p, T);
  F = 8 * randn (K, T);
  F(2, :) = 0.8 * F(1, :) + 0.6 * F(2, :);
  lab.name = 'linear';
  lab.means = @(theta, phi) 20 + (2 * theta - 1) * S + phi * F;
  lab.noiseSd = ones (1, T);
  lab.run = @(theta, phi) lab.means (theta, phi) + randn (rows (theta), T);
  lab.measure = @(theta, phi) lab.run (theta, phi) + 0.5 * randn (1, T);
  lab.isSigned = false (1, K);
  for k = K:-1:1
    name = sprintf ('e%d', k);
    effects(k) = struct ('name', name, 'variables', {{name}}, 'neutral', 0, ...
                         'limits', [0; 1], 'laboratory', false, 'offset', []);
  end
  lab.problem = struct ('value', 20 * ones (1, T), ...
                        'sd', 0.5 * ones (1, T), 'bench', ...
                        [ones(1, 7), 2 * ones(1, 7)], 'limits', ...
                        [zeros(1, p); ones(1, p)], 'effects', effects, ...
                        'noiseSd', lab.noiseSd);
  theta = rand (30 + 12 * K, p);
  phi = [zeros(30, K); kron(eye (K), (1:12)' / 12)];
  data = struct ('X', theta, 'E', phi, 'Z', lab.means (theta, phi), ...
                 'replicate', ones (rows (theta), 1));
  lab.em = fitEmulator (newProblem (lab.problem), data, ...
                        gapOptions (struct ('trend', 'affine')));
  lab.em.surrogateVar(:) = 0;
  lab.em.correlation = eye (T);
  for k = 1:K
    lab.em.effect(k).misfit(:) = 0;
    lab.em.effect(k).root(:) = 0;
  end
  lab.noise = sqrt (1.25) * ones (1, T);
  lab.data = data;
end

function lab = foreignOne ()
  lab = foreignLaboratories ('develop')(1);
  lab.run = foreignLab ('develop', 1).run;
end

function cases = casesOf (lab, level, n)
  mix = setfield (twinsMix ('foreign develop'), 'seed', 40000 + level);
  % the class whose effects are chosen so that they can reach the level
  mix.classes = {'off'};
  mix.shares = [];
  mix.levels.off = level;
  cases = {};
  twins = twinsDraw (lab, n, mix);
  for i = 1:numel (twins)
    if abs (twins(i).d - level) < 0.4
      cases{end + 1} = oneCase (lab, twins(i), level);
    end
  end
end

function c = oneCase (lab, twin, level)
  given = setfield (lab.problem, 'value', twin.y);
  problem = newProblem (given);
  options = gapOptions ([]);
  models = makeHypotheses (problem, lab.em, options);
  fits = fitLibrary (models, twin.y(problem.used));
  study = struct ('problem', problem, 'em', lab.em, 'models', models, ...
                  'fits', fits);
  low = given.limits(1, :);
  runs = @(X, E, r) lab.run ((X - low) ./ diff (given.limits), ...
                             strengthOfValues (problem.effects, E));
  state = newGapState (lab.data, setfield (options, 'maxNewRuns', 20), runs);
  others = setdiff (1:numel (problem.effects), twin.cause);
  [~, order] = sort (-fits.logE(1 + others));
  causes = [{twin.cause}, num2cell(others(order(1:2)))];
  sets = runCures (study, causes, state);
  cure = measureCure (study, sets, twin.cause, twin.cause);
  c = struct ('lab', lab.name, 'level', level, 'd', twin.d, ...
              'closure', cure.closure, 'interval', cure.interval90, ...
              'gapP', cure.gapP, 'largestZ', cure.largestZ, ...
              'placebos', cure.placebos);
end

function sayCases (name, level, cases)
  C = [cases.closure];
  seen = isfinite (C);
  if ~any (seen)
    printf ('%s, d = %g: no gap is seen in %d\n', name, level, numel (C));
    return
  end
  placebos = [cases(seen).placebos];
  rest = 1 - [placebos.expected];
  ends = vertcat (placebos.difference90);
  printf ('%s, d = %g: %d cases, a gap is seen in %d\n', name, level, ...
          numel (cases), sum (seen));
  printf ('  closure: median %.0f %%', 100 * median (C(seen)));
  sayShare (', intervals hold 1', holds (vertcat (cases(seen).interval), 1));
  printf ('  placebo: closes %.2f, expected %.2f in the median', ...
          median ([placebos.closure]), median ([placebos.expected]));
  sayShare ('; difference holds 1 - c^2', holds (ends, rest'));
  sayShare ('  placebo against the right cause', [placebos.against]);
end

function is = holds (ends, value)
  is = ends(:, 1) <= value & value <= ends(:, 2);
end

function sayShare (text, is)
  [lo, hi] = binomialInterval (sum (is), numel (is));
  printf ('%s: %d / %d = %.0f %% (%.0f - %.0f)\n', text, sum (is), ...
          numel (is), 100 * mean (is), 100 * lo, 100 * hi);
end

function writeCases (file, cases)
  text = sprintf ('lab,level,d,closure,lo,hi,gapP,largestZ,placebos\n');
  for c = cases
    p = c.placebos;
    each = sprintf ('%.4g/%.4g/%.4g ', [[p.closure]; [p.expected]; ...
                                        [p.difference]]);
    text = [text, sprintf('%s,%g,%.4g,%.4g,%.4g,%.4g,%.4g,%.4g,%s\n', ...
                          c.lab, c.level, c.d, c.closure, c.interval, ...
                          c.gapP, c.largestZ, strtrim (each))];
  end
  writeAtomic (file, text);
end

args = argv ();
n = 60;
if ~isempty (args)
  n = str2double (args{1});
end
runClosures (n);
