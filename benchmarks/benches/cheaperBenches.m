% CHEAPERBENCHES  Scatter, core-seconds and bias of benches with cheaper runs.
%
% CALL: octave-cli benchmarks/benches/cheaperBenches.m BENCH,BENCH N WORK CSV
%
%   N     packings of each variant, at most 8
%   WORK  folder of the runs; finished runs in it are reused
%   CSV   table, to which rows are added: bench, variant ('as it is', 'soft': a
%         fifth of Young's modulus, 'long': a time step of 0.5 Rayleigh times),
%         result, mean, sd (over the packings that give it), runs, seconds (of
%         processor, mean of a run)
%
% See also: benchRuns, compareVariants

1;

function list = variants ()
  list = struct ('name', {'as it is', 'soft', 'long'}, ...
                 'variables', {struct(), struct('youngsModulusP', 1e6), ...
                               struct('percentRayleigh', 0.5)});
end

function measure (bench, n, work, file, root)
  [~, counted] = startTable (file, 'bench,variant,result,mean,sd,runs,seconds', 1);
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

args = argv ();
addpath (fileparts (fileparts (mfilename ('fullpath'))));
addpath (fileparts (mfilename ('fullpath')));
root = startBenchmarks ();
useLiggghts (root);
for bench = strsplit (args{1}, ',')
  measure (bench{1}, str2double (args{2}), make_absolute_filename (args{3}), ...
           args{4}, root);
end
