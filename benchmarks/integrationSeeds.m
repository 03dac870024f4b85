% INTEGRATIONSEEDS  How much does the seed of the integration move a diagnosis?
%
% CALL: octave-cli benchmarks/integrationSeeds.m [seeds]
%
% The evidence of every hypothesis is integrated with 20 seeds: on the stored
% runs of examples/hiddenEffect, and on laboratories of formulas with 4, 7 and
% 10 parameters (18 targets on 3 benches, 5 effects, one of them planted).
% Writes results/integrationSeeds.csv: case, parameters, hypotheses integrated,
% largest and median standard deviation of a log evidence over the seeds, least
% effective number of points, verdicts, range of the ends of the strength
% interval of the likeliest effect over the seeds.
%
% See also: integrateEvidence

1;

function lab = formulaLab (p)
  rand ('twister', 600 + p);
  randn ('twister', 600 + p);
  T = 18;
  slope = 2 * randn (p, T);
  bend = 0.3 * randn (p, T);
  effect = 1.5 * randn (5, T);
  means = @(X, phi) 10 + (2 * X - 1) * slope + (2 * X - 1).^2 * bend + ...
                    phi.^0.7 * effect;
  n = 10 + 6 * p;
  lab.data.X = rand (n + 100, p);
  phi = zeros (n + 100, 5);
  for k = 1:5
    phi(n + 20 * k - 19:n + 20 * k, k) = 0.1 + 0.9 * rand (20, 1);
  end
  lab.data.E = phi;
  lab.data.Z = means (lab.data.X, phi) + 0.2 * randn (n + 100, T);
  lab.data.replicate = ones (n + 100, 1);
  for k = 1:5
    name = sprintf ('effect%d', k);
    effects(k) = struct ('name', name, 'variables', {{name}}, 'neutral', 0, ...
                         'limits', [0.1; 1]);
  end
  y = means (0.2 + 0.6 * rand (1, p), [0, 0.6, 0, 0, 0]);
  lab.given = struct ('value', y + 0.3 * randn (1, T), ...
                      'sd', 0.2 * ones (1, T), ...
                      'limits', [zeros(1, p); ones(1, p)], ...
                      'bench', kron (1:3, ones (1, 6)), 'effects', effects);
end

function lab = hiddenEffectLab (root)
  [lab.given, lab.data] = storedCampaign ('hiddenEffect', root);
end

function line = trySeeds (name, lab, seeds)
  gapProblem = newGapProblem (lab.given);
  options = gapOptions ([]);
  em = fitEmulator (gapProblem, lab.data, options);
  em.effect = em.effect([em.effect.laboratory] | [em.effect.runs] >= 3);
  models = omnibusReference (makeHypotheses (gapProblem, em, options));
  fits = fitLibrary (models, gapProblem.value(gapProblem.used));
  verdicts = {};
  for s = 1:seeds
    models.options.seed = s;
    w = caseEvidence (models, fits, 1);
    verdict = judgeCase (w, models);
    logE(s, :) = w.logE;
    done(s, :) = isfinite (w.ess);
    ess(s) = min (w.ess);
    interval(s, :) = w.phi(1 + verdict.top, :);
    said = models.names(verdict.effects);
    verdicts{s} = strjoin ([{verdict.kind}, said], ' ');
  end
  spread = std (logE(:, all (done, 1)));
  kinds = unique (verdicts);
  printf (['%s: %d parameters, %d integrals, scatter of log E %.3f at most ' ...
           '(median %.3f), least effective points %.0f\n  %s; strength of ' ...
           '%s from %.2f-%.2f to %.2f-%.2f\n'], name, em.p, numel (spread), ...
          max (spread), median (spread), min (ess), strjoin (kinds, ' | '), ...
          models.names{verdict.top}, min (interval(:, 2)), ...
          max (interval(:, 2)), min (interval(:, 3)), max (interval(:, 3)));
  line = sprintf ('%s,%d,%d,%.4f,%.4f,%.0f,%s,%.3f,%.3f,%.3f,%.3f', name, ...
                  em.p, numel (spread), max (spread), median (spread), ...
                  min (ess), strjoin (kinds, ' | '), min (interval(:, 2)), ...
                  max (interval(:, 2)), min (interval(:, 3)), ...
                  max (interval(:, 3)));
end

function runSeeds (seeds)
  addpath (fileparts (mfilename ('fullpath')));
  root = startBenchmarks ();
  lines = {['case,parameters,integrals,worstScatter,medianScatter,leastEss,' ...
            'verdicts,lo90min,lo90max,hi90min,hi90max']};
  lines{end + 1} = trySeeds ('hiddenEffect', hiddenEffectLab (root), seeds);
  for p = [4, 7, 10]
    name = sprintf ('formulas%d', p);
    lines{end + 1} = trySeeds (name, formulaLab (p), seeds);
  end
  writeAtomic (fullfile (root, 'benchmarks', 'results', ...
                         'integrationSeeds.csv'), [strjoin(lines, "\n"), "\n"]);
end

seeds = 20;
if numel (argv ()) > 0
  seeds = str2double (argv (){1});
end
runSeeds (seeds);
