% MATERIALSLIGGGHTS  Three materials one after another on a LIGGGHTS bench.
%
% CALL: octave-cli benchmarks/materialsLiggghts.m BENCH WORK [CSV]
%
% BENCH  'Lift100' (container of the default case), 'Drum' (slope at 2 and 8
%        rad/s) or 'SmallBin'
% WORK   folder that keeps the cases and their store; finished runs are used
%        again, so the same command goes on where it stopped
%
% Each material has targets and limits of its own (shifted by a quarter to half
% of the box) and is calibrated by `decalioc run` on the store that the ones
% before it have filled. The set that is found is then run with five fresh
% packings, in a store that no case reads. One CSV row a material and target:
% material, new runs, core-minutes of them, runs taken from the library, stated
% probability; target, tolerance, mean of the five packings, their standard
% deviation.
%
% About 20 minutes of one core for Lift100, 6 for Drum, 1 for SmallBin.
%
% See also: materials

1;

% Values of limits and targets: a row of the third dimension a material.
function bench = benchOf (name)
  friction = {'coefFrictionPP', 'coefFrictionPW', 'coefRollingFrictionPP', ...
              'coefRollingFrictionPW'};
  switch name
    case {'Lift100', 'SmallBin'}
      bench.names = [{'densityP'}, friction];
      box = [500, 0.3, 0.3, 0.025, 0.025; 800, 0.7, 0.7, 0.075, 0.075];
      shift = [0, 0, 0, 0, 0; 0.4, -0.25, 0.25, 0.5, 0; ...
               -0.3, 0.5, -0.25, 0.25, -0.3];
      bench.value = [400, 0.025; 450, 0.030; 340, 0.023];
      bench.tol = [0.01, 0.05];
      if strcmp (name, 'SmallBin')
        bench.value(:, 2) = [0.023; 0.027; 0.0205];
        bench.tol = [0.02, 0.05];
      end
      bench.targets = {'density', 'mass'};
    case 'Drum'
      bench.names = friction(1:3);
      box = [0.2, 0.2, 0; 0.8, 0.8, 0.15];
      shift = [0, 0, 0; 0.3, -0.3, 0.5; -0.2, 0.3, 0];
      bench.value = [36, 47.3; 39, 50.3; 34, 45.6];
      bench.tol = [0.03, 0.04];
      bench.targets = {'slope1', 'slope3'};
  end
  for k = 1:3
    bench.limits(:, :, k) = box + shift(k, :) .* diff (box);
  end
end

function raw = inputOf (name, bench, k, folder, store)
  raw.Input = struct ('model', {{name}}, 'cpu', 1, 'maxCPU', 1, 'numOfSam', ...
                      numel (bench.names) + 3, 'seed', k, 'store', store);
  raw.optim = struct ('maxIter', 3, 'maxFunEvals', 40, 'tolfun', 0.002, ...
                      'WRL', 0);
  if ~strcmp (name, 'Drum')              % its results have names: measured.csv
    raw.optim.targetVal = {bench.value(k, :)};
    raw.optim.tolRes = {bench.tol};
  end
  raw.modelVars = struct ();
  raw.assign = bench.names;
  raw.paramLims = bench.limits(:, :, k);
  raw.folder = folder;
end

function writeMeasured (bench, k, folder)
  cells = [bench.targets; num2cell([bench.value(k, :); bench.tol])];
  writeAtomic (fullfile (folder, 'measured.csv'), ...
               sprintf ("name,value,tol\n%s", ...
                        sprintf ("%s,%g,%g\n", cells{:})));
end

function writeCase (raw)
  [~, ~] = mkdir (raw.folder);
  save ('-binary', fullfile (raw.folder, 'input.mat'), '-struct', 'raw');
  lines = {['function [Input, optim, modelVars, assign, paramLims] = ', ...
            'loadInput ()'], ...
           's = load (fullfile (fileparts (mfilename (''fullpath'')), ', ...
           '          ''input.mat''));', ...
           'Input = s.Input;  optim = s.optim;  modelVars = s.modelVars;', ...
           'assign = s.assign;  paramLims = s.paramLims;', 'end'};
  writeAtomic (fullfile (raw.folder, 'loadInput.m'), ...
               strrep (strjoin (lines, "\n"), ", \n", ", ...\n"));
end

function R = oneMaterial (name, bench, k, work, root)
  folder = fullfile (work, sprintf ('material%d', k));
  raw = inputOf (name, bench, k, folder, fullfile (work, 'store'));
  writeCase (raw);
  if strcmp (name, 'Drum')
    writeMeasured (bench, k, folder);
  end
  system (sprintf ('%s run %s > %s 2>&1', ...
                   shellQuote (fullfile (root, 'bin', 'decalioc')), ...
                   shellQuote (folder), ...
                   shellQuote (fullfile (folder, 'console.txt'))));
  c = jsondecode (fileread (fullfile (folder, 'results', ...
                                      'calibration.json')));
  taken = checkReadText (fullfile (folder, 'results', 'library.csv'));
  runs = c.demRuns.plan + c.demRuns.infill + c.demRuns.verify;
  p = cellfun (@(n) c.params.(n), bench.names);
  raw.root = root;
  raw.Input.store = fullfile (work, 'fresh');
  raw.Input.seed = 1000 + k;
  Case = newCase (raw);
  Z = evaluateDEM (repmat (p, 5, 1), Case, (1:5)');
  R = zeros (0, 9);
  for t = 1:numel (bench.targets)
    R(t, :) = [k, runs, c.coreSeconds / 60, ...
               max(0, sum (taken == "\n") - 2), c.probability, ...
               bench.value(k, t), bench.tol(t), mean(Z(:, t)), std(Z(:, t))];
  end
  printf ('%s, material %d: %d new runs, %.1f core-minutes, %d of the ', ...
          name, k, R(1, 2:4));
  printf ('library; p %.2f; %s\n', c.probability, c.reason);
  cells = [bench.targets; num2cell([R(:, 6), R(:, 8), R(:, 9) / sqrt(5), ...
                                    100 * (R(:, 8) ./ R(:, 6) - 1), ...
                                    100 * R(:, 7)]')];
  printf (['   %s: target %g, five packings %.4g +- %.2g (%+.1f %% of ' ...
           '%g)\n'], cells{:});
  fflush (stdout);
end

history_save (false);
addpath (fileparts (mfilename ('fullpath')));
root = startBenchmarks ();
given = [argv(); {''}];
work = make_absolute_filename (given{2});
[~, ~] = mkdir (work);
bench = benchOf (given{1});
R = [];
for k = 1:3
  R = [R; oneMaterial(given{1}, bench, k, work, root)];
end
if ~isempty (given{3})
  writeMatrix (given{3}, R, {'material', 'new_runs', 'core_minutes', ...
                             'of_library', 'stated', 'target', ...
                             'tolerance', 'mean_of_five', 'sd_of_run'});
end
