% BENCHCASES  Calibrations of the rigs on LIGGGHTS, with and without form.csv.
%
% CALL: octave-cli benchmarks/benchCases.m BENCHES SEEDS WAYS WORK CSV
%
%   BENCHES  rigs of DEMmodels, e.g. Heap,Drum
%   SEEDS    e.g. 1:20, each another material, plan and packings
%   WAYS     of these, separated by commas:
%     form   as decalioc new --bench makes the case
%     none   without form.csv, with a plan of d + 3
%     none2  without form.csv, with the plan of d + 2 that form.csv allows
%     half   form.csv with the sign of every second parameter wrong
%     other  form.csv in which each result has the rows of the next one
%   WORK     folder of the cases and runs, kept; what lies there goes on
%   CSV      table, to which one row a case is added; those that stand in it are not
%            made again
%
% Rig and grains are others than those of form.csv: the rig as benchLarger enlarges
% it, grains of 2500 kg/m3, wall friction 0.4, restitution 0.5. Sliding and rolling
% friction are drawn from the middle 80 % of the limits; six packings there are the
% measurement, of the results whose tolerance in measured.csv is at most 10 %. Right:
% the means of eight further packings at the set that is handed back are within all
% tolerances. worst: the largest of these misses, and se its standard error, both in
% tolerances.
%
% See also: reposeSeeds, benchLarger, benchForms

1;

function cells = oneCase (benches, way, seed, work, root)
  started = time ();
  rig = rigOf (benches, seed);
  measured = packings (benches, rig, 1:6, fullfile (work, sprintf ('%d-measured', seed)));
  folder = fullfile (work, sprintf ('%d-%s', seed, way));
  if ~isfolder (folder)
    writeCase (folder, benches, way, seed, root, rig, mean (measured, 1));
  end
  call (sprintf ('%s run %s', shellQuote (fullfile (root, 'bin', 'decalioc')), ...
                 shellQuote (folder)));
  c = jsondecode (fileread (fullfile (folder, 'results', 'calibration.json')));
  for name = fieldnames (c.params)'
    rig.(name{1}) = c.params.(name{1});
  end
  [off, se] = missOf (c.targets, benches, root, ...
                      packings (benches, rig, 7:14, [folder, '-judged']));
  [worst, at] = max (off);
  cells = {c.demRuns.plan + c.demRuns.infill + c.demRuns.verify, c.coreSeconds, ...
           double(c.converged), c.probability, double(worst < 1), worst, se(at), ...
           time() - started};
end

% Misses of the means of Z (a row a packing, all results of all benches), in tolerances.
function [off, se] = missOf (targets, benches, root, Z)
  labels = {};
  for bench = benches
    info = resultInfo (fullfile (root, 'DEMmodels', bench{1}));
    labels = [labels, strcat([bench{1}, '.'], {info.name})];
  end
  wanted = strcat ({targets.model}, {'.'}, {targets.name});
  [~, at] = ismember (wanted, labels);
  value = [targets.target];
  part = [targets.tol] .* abs (value);
  off = abs (mean (Z(:, at), 1) - value) ./ part;
  se = std (Z(:, at)) / sqrt (rows (Z)) ./ part;
end

% Variables of rig and grains, with the friction that is to be found.
function rig = rigOf (benches, seed)
  rig = struct ();
  for bench = benches
    larger = benchLarger (bench{1});
    for name = fieldnames (larger)'
      rig.(name{1}) = larger.(name{1});
    end
  end
  rand ('twister', 4e6 + seed);
  u = 0.1 + 0.8 * rand (1, 2);
  rig.densityP = 2500;
  rig.coefFrictionPW = 0.4;
  rig.coefRestitutionPP = 0.5;
  rig.coefFrictionPP = 0.2 + 0.6 * u(1);
  rig.coefRollingFrictionPP = 0.02 + 0.28 * u(2);
end

% A row a packing, all results of all benches.
function Z = packings (benches, rig, which, folder)
  seeds = primes (3e4)(2500:2600);
  [~, ~] = mkdir (folder);
  for i = 1:numel (which)
    rig.runSeed = seeds(which(i));
    results = cellfun (@(b) benchRun (fullfile (folder, sprintf ('%s-%d', b, which(i))), ...
                                      b, rig), benches, 'UniformOutput', false);
    Z(i, :) = [results{:}];
  end
end

% The case as new --bench makes it, with this rig and these values.
function writeCase (folder, benches, way, seed, root, rig, values)
  call (sprintf ('%s new --bench %s %s < /dev/null', ...
                 shellQuote (fullfile (root, 'bin', 'decalioc')), ...
                 strjoin (benches, ','), shellQuote (folder)));
  file = fullfile (folder, 'measured.csv');
  [header, lines] = readCsvTable (file);
  use = str2double (strrep (lines(:, strcmp (header, 'tol')), '%', '')) <= 10;
  lines(use, strcmp (header, 'value')) = ...
    arrayfun (@(z) sprintf ('%.6g', z), values(use), 'UniformOutput', false);
  text = cellfun (@(i) strjoin (lines(i, :), ','), num2cell (find (use)), ...
                  'UniformOutput', false);
  writeAtomic (file, sprintf ('%s\n', strjoin (header, ','), text{:}));
  file = fullfile (folder, 'loadInput.m');
  text = fileread (file);
  free = {'coefFrictionPP', 'coefRollingFrictionPP', 'densityP'};
  rest = rmfield (rig, free);
  given = cellfun (@(n) sprintf ('  modelVars.%s = %.12g;\n', n, rest.(n)), ...
                   fieldnames (rest)', 'UniformOutput', false);
  text = regexprep (text, 'modelVars\.densityP = [^\n]*', ...
                    sprintf ('modelVars.densityP = %g;', rig.densityP));
  text = strrep (text, '  % --- 3 ', [given{:}, '  % --- 3 ']);
  text = strrep (text, 'Input.seed = 1;', sprintf ('Input.seed = %d;', seed));
  if strcmp (way, 'none')
    text = regexprep (text, 'numOfSam = \d+', 'numOfSam = 5');
  end
  writeAtomic (file, text);
  if ~strcmp (way, 'form')
    spoilForms (benches, way, folder, root);
  end
end

% Models of the case's own, which go before the toolbox's.
function spoilForms (benches, way, folder, root)
  for bench = benches
    models = fullfile (folder, 'DEMmodels');
    [~, ~] = mkdir (models);
    call (sprintf ('cp -rL %s %s', shellQuote (fullfile (root, 'DEMmodels', bench{1})), ...
                   shellQuote (models)));
    file = fullfile (models, bench{1}, 'form.csv');
    [header, lines] = readCsvTable (file);
    unlink (file);
    if strcmp (way, 'half')
      isWrong = strcmp (lines(:, 2), 'coefRollingFrictionPP');
      lines(isWrong, 5:6) = cellfun (@(x) sprintf ('%.12g', -str2double (x)), ...
                                     lines(isWrong, 5:6), 'UniformOutput', false);
    elseif strcmp (way, 'other')
      results = unique (lines(:, 1), 'stable');
      [~, at] = ismember (lines(:, 1), results);
      lines(:, 1) = results(mod (at, numel (results)) + 1);
    end
    if any (strcmp (way, {'half', 'other'}))
      text = cellfun (@(i) strjoin (lines(i, :), ','), num2cell (1:rows (lines)), ...
                      'UniformOutput', false);
      writeAtomic (file, sprintf ('%s\n', strjoin (header, ','), text{:}));
    end
  end
end

% Exit status 2: not all targets are met.
function call (line)
  [status, text] = system ([line, ' 2>&1']);
  if ~any (status == [0, 2])
    error ('DEcalioc:benchCases:runFailed', ...
           'benchCases: %s must end well, got status %d: %s', line, status, text);
  end
end

addpath (fileparts (mfilename ('fullpath')));
root = startBenchmarks ();
given = argv ();
benches = strsplit (given{1}, ',');
work = make_absolute_filename (given{4});
[~, ~] = mkdir (work);
lists = {{strjoin(benches, '+')}, strsplit(given{3}, ','), str2num(given{2})};
fillTable (given{5}, ['benches,way,seed,runs,seconds,converged,probability,right,worst,', ...
                      'se,wall'], lists, ...
           @(~, way, seed) oneCase (benches, way, seed, work, root));

% SPDX-License-Identifier: GPL-3.0-only
