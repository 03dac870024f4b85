% LIFT100RESPONSE  Measures noise of a run and response of a container model.
%
% CALL: lift100Response ()
%       lift100Response (model)
%       lift100Response (model, nParallel)
%       lift100Response (model, nParallel, work)
%
%   model       text: 'Lift100' (default) or 'SmallBin'
%   nParallel   scalar: how many runs at once; default: processors
%   work        text: folder of the runs, kept; finished runs in it are not run
%               again. Default: a temporary folder, removed at the end
%
% Runs on LIGGGHTS: the centre of the document's box with 5 seeds, and a half
% fraction of the two-level factorial plan of the five design variables (16
% corners of the box: the product of all five signs is +1), each with a seed
% of its own. Effects from lower to upper limit by least squares on the finished
% runs; with all 21 runs the standard error is half the noise of a run.
% Writes one row a run to benchmarks/results/<model>.csv and
% prints the tables that stand in the model's README. Lift100: 21 runs, about
% 10 minutes of one core.
%
% In Octave, in the folder of the repository:
%   addpath benchmarks; startBenchmarks (); lift100Response ('Lift100')
%
% See also: getResults

function lift100Response (model, nParallel, work)

  if nargin < 1
    model = 'Lift100';
  end
  if nargin < 2
    nParallel = nproc ();
  end
  root = startBenchmarks ();
  names = {'densityP', 'coefFrictionPP', 'coefFrictionPW', ...
           'coefRollingFrictionPP', 'coefRollingFrictionPW'};
  limits = [500, 0.3, 0.3, 0.025, 0.025; 800, 0.7, 0.7, 0.075, 0.075];
  plan = makePlan (limits);

  keep = nargin > 2;
  if ~keep
    work = tempname ();
  end
  modelFolder = fullfile (root, 'DEMmodels', model);
  for k = 1:rows (plan)
    prepare (modelFolder, fullfile (work, sprintf ('run%03d', k)), names, ...
             plan(k, :));
  end
  system (sprintf (['cd ''%s'' && ls -d run* | xargs -P %d -I{} bash -c ' ...
                    '''cd {} && { [ -e output_mass ] || { TIMEFORMAT=%%U; ' ...
                    '{ time bash runscript > stdout.txt 2> stderr.txt; } ' ...
                    '2> cpu.txt; }; }'''], work, nParallel));
  runs = zeros (rows (plan), 10);
  for k = 1:rows (plan)
    runs(k, :) = collect (fullfile (work, sprintf ('run%03d', k)));
  end
  writeRuns (fullfile (root, 'benchmarks', 'results', [model, '.csv']), ...
             names, [plan, runs]);
  sayTables (names, plan, runs);
  if ~keep
    confirm_recursive_rmdir (false, 'local');
    rmdir (work, 's');
  end

end

% Rows of five design variables and a seed, 21 x 6.
function plan = makePlan (limits)

  signs = 2 * (dec2bin (0:15) - '0') - 1;
  signs = [signs, prod(signs, 2)];
  centre = mean (limits);
  corners = centre + signs .* diff (limits) / 2;
  seeds = primes (11000);
  seeds = seeds(seeds > 10000)(1:21)';
  plan = [[repmat(centre, 5, 1); corners], seeds];

end

function prepare (modelFolder, folder, names, row)

  if exist (folder, 'dir') == 7
    return
  end
  mkdir (folder);
  copyfile (fullfile (modelFolder, '*'), folder);
  fid = fopen (fullfile (folder, 'data.head'), 'a');
  for j = 1:numel (names)
    fprintf (fid, 'variable %s equal %.17g\n', names{j}, row(j));
  end
  fprintf (fid, 'variable runSeed equal %d\n', row(end));
  fclose (fid);

end

% One row: density, mass, core seconds, spheres kept, their share of those
% filled in, deepest overlap, seconds of settling and of discharge, whether
% both ended at rest (0 to 2), time step.
function row = collect (folder)

  row = NaN (1, 10);
  file = fullfile (folder, 'output_checks.csv');
  if exist (file, 'file') ~= 2
    return
  end
  text = fileread (file);
  value = @(name) str2double (regexp (text, ['^', name, ',(\S+)$'], ...
                                      'tokens', 'once', 'lineanchors'));
  number = @(name) str2double (fileread (fullfile (folder, name)));
  kept = value ('spheresKept');
  row = [number('output_density'), number('output_mass'), ...
         number('cpu.txt'), kept, kept / value('spheresFilled'), ...
         value('overlapMax'), value('settleSeconds'), ...
         value('dischargeSeconds'), ...
         value('settleByRest') + value('dischargeByRest'), ...
         value('timeStep')];

end

function writeRuns (file, names, data)

  header = strjoin ([names, {'runSeed', 'density', 'mass', 'coreSeconds', ...
                             'spheres', 'keptShare', 'overlapMax', ...
                             'settleSeconds', 'dischargeSeconds', ...
                             'endedAtRest', 'timeStep'}], ',');
  fid = fopen (file, 'w');
  fprintf (fid, '%s\n', header);
  format = [strjoin(repmat ({'%.10g'}, 1, columns (data)), ','), '\n'];
  fprintf (fid, format, data');
  fclose (fid);

end

function sayTables (names, plan, runs)

  z = runs(:, 1:2);
  centre = z(1:5, :);
  noise = 100 * std (centre) ./ mean (centre);
  printf ('runs %d, not finished %d; core seconds %.1f to %.1f\n', ...
          rows (z), sum (any (isnan (z), 2)), min (runs(:, 3)), ...
          max (runs(:, 3)));
  printf ('spheres %d to %d, overlap at most %.2f %%\n', min (runs(:, 4)), ...
          max (runs(:, 4)), 100 * max (runs(:, 6)));
  printf ('centre: %.1f kg/m3 +- %.2f %%, %.5f kg +- %.2f %% (5 seeds)\n', ...
          mean (centre(:, 1)), noise(1), mean (centre(:, 2)), noise(2));
  done = all (isfinite (z), 2);
  low = min (plan(:, 1:5));
  high = max (plan(:, 1:5));
  A = [ones(rows (plan), 1), (plan(:, 1:5) - low) ./ (high - low)];
  A = A(done, :);
  effect = A \ z(done, :);
  spread = sqrt (diag (inv (A' * A))) * std (centre);
  printf ('\n| variable | from | to | density (kg/m3) | mass (g) |\n');
  printf ('|---|---|---|---|---|\n');
  for j = 1:5
    printf ('| %s | %g | %g | %+.1f +- %.1f | %+.2f +- %.2f |\n', ...
            names{j}, low(j), high(j), effect(j + 1, 1), ...
            spread(j + 1, 1), 1e3 * effect(j + 1, 2), ...
            1e3 * spread(j + 1, 2));
  end
  volume = 1e6 * z(:, 2) ./ z(:, 1);
  printf ('\nresponses: %.0f to %.0f kg/m3, %.4f to %.4f kg, ', ...
          min (z(:, 1)), max (z(:, 1)), min (z(:, 2)), max (z(:, 2)));
  printf ('mass / density %.1f to %.1f cm3\n', min (volume), max (volume));

end
