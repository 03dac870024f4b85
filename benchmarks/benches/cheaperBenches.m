% CHEAPERBENCHES  Scatter, core-seconds and bias of benches with cheaper runs.
%
% CALL: octave-cli benchmarks/benches/cheaperBenches.m BENCH,BENCH N WORK CSV
%       octave-cli benchmarks/benches/cheaperBenches.m report CSV
%
%   N     packings of each variant, at most 8
%   WORK  folder of the runs; finished runs in it are reused
%   CSV   table, to which rows are added: bench, variant ('as it is', 'soft': a
%         fifth of Young's modulus, 'long': a time step of 0.5 Rayleigh times),
%         result, mean, sd (over the packings that give it), runs, seconds (of
%         processor, mean of a run)
%
% 'report': of each bench and variant what a run costs over a run as it is; the
% geometric mean over the results of its variance over theirs; the product of
% both; and of how many results the mean shifts by more than one deviation of a run
% for sure (95 %, all results of a bench together: Bonferroni), or is not known to
% shift by less.
%
% See also: benchRuns, compareVariants

1;

function list = variants ()
  list = struct ('name', {'as it is', 'soft', 'long'}, ...
                 'variables', {struct(), struct('youngsModulusP', 1e6), ...
                               struct('percentRayleigh', 0.5)});
end

function measure (bench, n, work, file, root)
  if ~exist (file, 'file')
    appendLine (file, 'bench,variant,result,mean,sd,runs,seconds');
  end
  info = resultInfo (fullfile (root, 'DEMmodels', bench));
  for variant = variants ()
    stem = fullfile (work, [bench, '-', strrep(variant.name, ' ', '')]);
    [Z, ~, seconds] = benchRuns (stem, bench, variant.variables, n);
    for t = 1:columns (Z)
      z = Z(isfinite (Z(:, t)), t);
      appendLine (file, rowText ({bench, variant.name, info(t).name, ...
                                  sprintf('%.7g', mean (z)), std(z), numel(z), ...
                                  mean(seconds)}));
    end
  end
end

function report (file)
  list = tableRows (file);
  number = @(rows_, name) cellfun (@str2double, {rows_.(name)});
  for bench = unique ({list.bench}, 'stable')
    own = list(strcmp ({list.bench}, bench{1}));
    base = own(strcmp ({own.variant}, 'as it is'));
    for name = {'soft', 'long'}
      new = own(strcmp ({own.variant}, name{1}));
      cost = number (new, 'seconds')(1) / number (base, 'seconds')(1);
      variance = (number (new, 'sd') ./ number (base, 'sd')).^2;
      df = number (new, 'runs') + number (base, 'runs') - 2;
      sd = sqrt ((number (new, 'sd').^2 + number (base, 'sd').^2) / 2);
      shift = abs (number (new, 'mean') - number (base, 'mean')) ./ sd;
      doubt = arrayfun (@(v) studentQuantile (1 - 0.05 / numel (df), v), df) .* ...
              sqrt (1 ./ number (new, 'runs') + 1 ./ number (base, 'runs'));
      ratio = exp (mean (log (variance(isfinite (variance) & variance > 0))));
      printf (['%-9s %-5s cost %.2f, variance %.2f, product %.2f; of %d results ', ...
               '%d shift, %d are open; runs without results %d\n'], bench{1}, ...
              name{1}, cost, ratio, cost * ratio, numel (df), ...
              sum (shift - doubt > 1), sum (shift + doubt > 1 & shift - doubt <= 1), ...
              max (number (base, 'runs')) - min (number (new, 'runs')));
    end
  end
end

args = argv ();
addpath (fileparts (fileparts (mfilename ('fullpath'))));
addpath (fileparts (mfilename ('fullpath')));
root = startBenchmarks ();
if strcmp (args{1}, 'report')
  report (args{2});
else
  useLiggghts (root);
  for bench = strsplit (args{1}, ',')
    measure (bench{1}, str2double (args{2}), make_absolute_filename (args{3}), ...
             args{4}, root);
  end
end
