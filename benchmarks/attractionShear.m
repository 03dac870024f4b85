% ATTRACTIONSHEAR  What each law of attraction does to the yield line of Shear.
%
% CALL: attractionShear (WORK, NSEEDS)
%
%   WORK    text, folder of the runs; finished runs in it are reused
%   NSEEDS  number of seeds of each strength (default 2)
%
% Shear cell of the toolbox at neutral parameters. Writes
% benchmarks/results/attractionShear.csv (law, strength, unit, bond, intercept,
% interceptError, friction, frictionError) and prints it. bond: pull-off force
% over the weight of a grain, where the law has one at zero overlap (a bridge:
% its force at contact); error: standard error of the mean. About 2 minutes of
% processor time with 2 seeds.
%
% See also: benchRun, effectPullOff, effectCohesion, effectLiquidBridge
function attractionShear (work, nSeeds)
  if nargin < 2
    nSeeds = 2;
  end
  root = startBenchmarks ();
  rowsOf = @(name, unit, values) [repmat({name, unit}, numel (values), 1), ...
                                  num2cell(values(:))];
  cases = [rowsOf('none', '-', 0); ...
           rowsOf('adhesionPP', 'J/m2', [0.05, 0.1, 0.2]); ...
           rowsOf('cohesionPP', 'J/m3', 6e4); ...
           rowsOf('liquidContent', '-', 0.02)];
  [at, seed] = ndgrid (1:rows (cases), benchSeeds (1:nSeeds));
  folders = arrayfun (@(k, s) fullfile (work, sprintf ('%s-%g-%d', ...
                                                       cases{k, 1}, cases{k, 3}, s)), at, seed, ...
                      'UniformOutput', false);
  sets = arrayfun (@(k, s) struct ('runSeed', s, cases{k, 1}, cases{k, 3}), ...
                   at, seed, 'UniformOutput', false);
  results = parcellfun (nproc (), @benchRun, folders(:)', ...
                        repmat ({'Shear'}, 1, numel (at)), sets(:)', ...
                        'UniformOutput', false, 'VerboseLevel', 0);
  names = {resultInfo(fullfile (root, 'DEMmodels', 'Shear')).name};
  wanted = cellfun (@(n) find (strcmp (names, n)), {'intercept', 'friction'});
  text = ["law,strength,unit,bond,intercept,interceptError,friction,", ...
          "frictionError\n"];
  for k = 1:rows (cases)
    found = vertcat (results{at == k});
    found = found(all (isfinite (found), 2), wanted);
    both = [mean(found, 1); std(found, 0, 1) / sqrt(rows (found))];
    text = [text, sprintf("%s,%g,%s,%.3g,%.3g,%.2g,%.4f,%.2g\n", ...
                          cases{k, [1, 3, 2]}, bondOf(cases{k, [1, 3]}), ...
                          both)];
  end
  writeAtomic (fullfile (root, 'benchmarks', 'results', ...
                         'attractionShear.csv'), text);
  printf ('%s', text);
end

% Over the weight of a grain of Shear, 4/3 pi 2 mm^3 x 1200 kg/m3.
function bond = bondOf (name, strength)
  radius = 2e-3;
  weight = 4 / 3 * pi * radius^3 * 1200 * 9.81;
  bond = 0;
  if strcmp (name, 'adhesionPP')
    bond = pi * radius * strength / weight;
  elseif strcmp (name, 'liquidContent')
    v = 4 / 3 * pi * strength * (1 - sqrt (0.75));
    bond = pi * 0.072 * radius * (exp (0.48 - 0.0082 * log (v)) + ...
                                  0.078 + 0.0018 * log (v)) / weight;
  end
end

%!test % the new law raises the intercept and leaves the friction; SJKR raises that
%! root = startBenchmarks ();
%! [~, table] = readCsvTable (fullfile (root, 'benchmarks', 'results', ...
%!                                      'attractionShear.csv'));
%! value = str2double (table);
%! of = @(name) value(strcmp (table(:, 1), name), :);
%! none = of ('none');
%! dmt = of ('adhesionPP');
%! assert (all (diff ([none(5); dmt(:, 5)]) > 0));
%! assert (dmt(end, 5) - none(5) > 12);
%! assert (all (abs (dmt(:, 7) - none(7)) < 0.01));
%! assert (of ('cohesionPP')(7) - none(7) > 0.04);
