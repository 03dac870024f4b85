% DRUMLEVELS  A drum calibrated at one grain scale, and with coarser levels.
%
% CALL: octave-cli benchmarks/drumLevels.m WORK [SEED]
%
% WORK  folder for the cases and their runs; what is there is not run again
% SEED  of plan and packings (1)
%
% The drum of examples/granudrum at 30 and 60 rpm. What is to be met is made by
% the drum itself, with grains twice too large: the mean of two packings at
% sliding friction 0.5, rolling friction 0.2 and a solid share of 0.245, both
% surfaces to 1 mm. Calibrated twice, each with a store of its own: with runs at
% grainScale 2 alone, and with Input.coarse levels 4, 3 and 2. Then the set that
% the levels found is run at grainScale 1.5 and laid beside what the surrogates
% extrapolate. One row a way in results/drumLevels.csv.
%
% Core time: runs at each level times the mean time of a run at that level in
% both cases, as both are at the mercy of what else the machine does.
%
% See also: coarseRuns, chooseLevels

1;

function place = caseAt (work, root, name, lines, seed)
  place = fullfile (work, sprintf ('%s-%d', name, seed));
  [~, ~] = mkdir (place);
  if ~exist (fullfile (place, 'DEMmodels'), 'dir')
    system (sprintf ('cp -rL "%s" "%s"', fullfile (root, 'examples', ...
                                                   'granudrum', ...
                                                   'DEMmodels'), place));
  end
  text = {'function [Input, optim, modelVars, assign, paramLims] = loadInput ()'
          '  Input = struct (''model'', {{''GranuDrum''}}, ''cpu'', 1);'
          '  Input.maxCPU = 1;'
          '  Input.numOfSam = 6;'
          sprintf('  Input.seed = %d;', seed)
          '  optim = struct (''maxFunEvals'', 14, ''correlation'', {{100}});'
          '  modelVars = struct (''speedSlow'', 30, ''speedFast'', 60);'
          '  assign = {''coefFrictionPP'', ''coefRollingFrictionPP'', ...'
          '            ''drumSolid''};'
          '  paramLims = [0.2, 0.02, 0.21; 1, 0.9, 0.29];'};
  text = [text; lines(:); {'end'; ''}];
  writeAtomic (fullfile (place, 'loadInput.m'), strjoin (text', "\n"));
end

function Case = loaded (root, place)
  cd (place);                 % the folder one is in goes before the path
  startToolbox (root, place);
  Case = loadCase (root, place);
end

% The surfaces that are to be met, as measured.csv has them.
function makeTruth (work, root, seed)
  places = cellfun (@(n) fullfile (work, sprintf ('%s-%d', n, seed)), ...
                    {'fine', 'levels'}, 'UniformOutput', false);
  source = fullfile (root, 'examples', 'granudrum', 'measured.csv');
  place = caseAt (work, root, 'truth', {'  modelVars.grainScale = 2;'}, seed);
  copyfile (source, place);
  Case = loaded (root, place);
  Z = evaluateDEM (repmat ([0.5, 0.2, 0.245], 2, 1), Case, [101; 102], ...
                   'plan', newProgress ('plan', @disp));
  [head, cells] = readCsvTable (source);
  cells(:, strcmp (head, 'value')) = arrayfun (@(z) sprintf ('%.4f', z), ...
                                               mean (Z)', ...
                                               'UniformOutput', false);
  rowsOf = [head; cells];
  lines = arrayfun (@(i) strjoin (rowsOf(i, :), ','), 1:rows (rowsOf), ...
                    'UniformOutput', false);
  for k = 1:2
    writeAtomic (fullfile (places{k}, 'measured.csv'), ...
                 [strjoin(lines, "\n"), "\n"]);
  end
end

function c = calibrated (place, root)
  file = fullfile (place, 'results', 'calibration.json');
  if ~isfile (file)
    system (sprintf ('cd "%s" && octave-cli "%s" > log 2>&1', place, ...
                     fullfile (root, 'DEcalioc.m')));
  end
  c = jsondecode (fileread (file));
end

% Seconds and level of each finished run.
function [seconds, level] = runsOf (place)
  [seconds, level] = deal ([]);
  names = listRunFolders (place, 'GranuDrum');
  for k = 1:numel (names)
    folder = fullfile (place, 'optim', 'GranuDrum', names{k});
    r = readRecord (fullfile (folder, 'record.json'));
    seconds(end + 1) = r.seconds;
    level(end + 1) = headDefaults (fullfile (folder, 'data.head')).grainScale;
  end
end

% The set found with levels, one level finer than the finest.
function sayBeyond (place, root, c)
  Case = loaded (root, place);
  p = struct2cell (c.params);
  p = [p{:}];
  z = evaluateDEM (p, Case, 201, 'verify', newProgress ('verify', @disp), 1.5);
  coarse = newProblem (Case, []).coarse;
  inside = zeros (size (z));
  m = z;
  sd = z;
  for t = 1:numel (z)
    s = loadSurrogate (fullfile (place, 'results', 'surrogates', ...
                                 sprintf ('KM_fun_%d.txt', t)));
    at = [p, unitLevel(coarse, 1.5, t)];
    if isempty (s.level)
      at = p;
    end
    [m(t), v] = predictSurrogate (s, at);
    sd(t) = sqrt (v + s.noiseVar);
    inside(t) = abs (z(t) - m(t)) <= studentQuantile (0.95, s.df) * sd(t);
  end
  printf (['grainScale 1.5: %d of %d points in their 90 %% intervals, rms ' ...
           'of run less prediction %.2f mm, mean half width %.2f mm, ' ...
           'change from grainScale 2 %.2f mm rms\n'], ...
          sum (inside), numel (z), ...
          norm (z - m) / sqrt (numel (z)), mean (1.645 * sd), ...
          norm (z - [c.targets.result]) / sqrt (numel (z)));
end

function compareWays (work, seed)
  addpath (fileparts (mfilename ('fullpath')));
  root = startBenchmarks ();
  fine = caseAt (work, root, 'fine', {'  modelVars.grainScale = 2;'}, seed);
  levels = caseAt (work, root, 'levels', ...
                   {'  Input.coarse = {struct(''variable'', ...'
                    '                         ''grainScale'', ...'
                    '                         ''levels'', [4, 3, 2])};'}, seed);
  if ~isfile (fullfile (levels, 'measured.csv'))
    makeTruth (work, root, seed);
  end
  both = {calibrated(levels, root), calibrated(fine, root)};
  [s1, l1] = runsOf (levels);
  [s2, l2] = runsOf (fine);
  known = [4, 3, 2];
  each = arrayfun (@(l) mean ([s1(l1 == l), s2(l2 == l)]), known);
  counts = [sum(l1(:) == known, 1); sum(l2(:) == known, 1)];
  cost = counts * each';
  names = fieldnames (both{1}.params)';
  R = [];
  for k = 1:2
    c = both{k};
    p = struct2cell (c.params);
    w = struct2cell (c.interval90);
    R(k, :) = [seed, counts(k, :), cost(k), c.converged, c.probability, ...
               p{:}, reshape([w{:}]', 1, [])];
  end
  head = [{'seed', 'runs4', 'runs3', 'runs2', 'coreSeconds', 'converged', ...
           'probability'}, names, strcat(names, '_lo90'), ...
          strcat(names, '_hi90')];
  disp (head);
  disp (R);
  printf ('cost with levels %.2f of the cost without\n', cost(1) / cost(2));
  writeMatrix (fullfile (work, sprintf ('drumLevels-%d.csv', seed)), R, head);
  sayBeyond (levels, root, both{1});
end

given = argv ();
seed = 1;
if numel (given) > 1
  seed = str2double (given{2});
end
compareWays (make_absolute_filename (given{1}), seed);
