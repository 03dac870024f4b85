% FLOORS  Runs to values that are right and stated right: the floor, and ours.
%
% CALL: octave-cli benchmarks/floors.m STANDIN SEEDS WAYS CSV
%       octave-cli benchmarks/floors.m report CSV
%
%   STANDIN  a name of standIn;  SEEDS  e.g. 1:20
%   WAYS     of these, separated by commas, in the order of the table:
%     told    somebody is told right values, whose results are the targets, and
%             makes runs there alone, with the noise of a run known, until
%             confirmSet states 0.95
%     form    this calibration, but trend, ranges, bends and noise of each
%             response are known beforehand (learnForm)
%     known   this calibration, and 8 packings of one set before have told of the
%             noise (scatter.csv); they are not counted
%     ours    this calibration
%   CSV      table, to which one row a seed is added; seeds that stand in it are
%            not run again
%
% All else is as the toolbox has it by default. One row: standin, way, seed, runs,
% converged, right, worst (true miss, in tolerances), probability, infill,
% verify, seconds.
%
% 'report' counts a seed whose values are not right, or not stated, as one that
% never ends. Median (quartiles); of so many seeds stated, of them right. The
% ratios (form / told, known / form, ours / form) are those of the medians, with
% intervals of 95 % from 2000 samples of the seeds of either way. Below, the same of
% results/peers.csv.
%
% See also: calibrateStandIn, learnForm, standIn, peers

1;

function measure (name, seeds, ways, file)
  columnsOf = ['standin,way,seed,runs,converged,right,worst,probability,', ...
               'infill,verify,seconds'];
  done = {};
  if exist (file, 'file')
    done = regexp (fileread (file), '^\w+,\w+,\d+', 'match', 'lineanchors');
  else
    appendLine (file, columnsOf);
  end
  form = [];
  for seed = seeds
    S = standIn (name, seed);
    for way = ways
      if any (strcmp (done, sprintf ('%s,%s,%d', name, way{1}, seed)))
        continue
      end
      if isempty (form) && strcmp (way{1}, 'form')
        form = learnForm (S);
        sayForm (form, S.targetNames);
      end
      appendLine (file, rowText ([{name, way{1}, seed}, ...
                                  oneSeed(S, way{1}, seed, form)]));
    end
  end
end

function sayForm (form, names)
  for t = 1:numel (form)
    f = form(t);
    printf ('%s: %s, %s, bends%s, ranges%s, log density %.3f\n', names{t}, ...
            f.trend, f.covariance, sprintf (' %g', f.limits(4, :)), ...
            sprintf (' %.2f', exp (-f.param(2:end))), f.score);
  end
end

function cells = oneSeed (S, way, seed, form)
  started = tic ();
  if strcmp (way, 'told')
    r = confirmTold (S, seed);
    worst = 0;
  else
    if strcmp (way, 'form')
      S.form = form;
    elseif strcmp (way, 'known')
      S.earlier = 8;
    end
    r = calibrateStandIn (S, seed, 0, struct ());
    tol = givenField (S, 'tol', 0.01);
    worst = max (abs (S.response (r.params) ./ S.value - 1) ./ tol);
  end
  cells = {r.runs, r.converged, worst < 1, worst, r.probability, r.infill, ...
           r.verify, toc(started)};
end

% Where in the box the values are does not matter to runs at one place.
function r = confirmTold (S, seed)
  rand ('twister', seed);
  randn ('twister', seed);
  T = numel (S.value);
  d = numel (S.names);
  p = boxCentre (S.limits);
  tol = givenField (S, 'tol', 0.01 * ones (1, T));
  problem = newProblem (struct ('names', {S.names}, 'limits', S.limits, ...
                                'options', struct (), 'targets', ...
                                struct ('name', S.targetNames, ...
                                        'value', num2cell (S.value), ...
                                        'tol', num2cell (tol), 'sd', 0, ...
                                        'role', 'calibrate', 'model', 1)));
  sd = S.noise .* abs (S.value);
  for t = 1:T
    problem.form(t) = struct ('trend', 'constant', 'covariance', 'gauss', ...
                              'param', zeros (d + 1, 1), ...
                              'limits', S.limits, 'shift', S.value(t), ...
                              'scale', sd(t), 'noise', @(z) sd(t)^2 + 0 * z);
  end
  state = newState (newData (d, T));
  run = @(P, E, k) S.value .* (1 + S.noise .* randn (rows (P), T));
  [state.evaluate, state.budget] = newEvaluate (run);
  state.found = struct ('params', p, 'conflict', {{}});
  state = addRuns (state, problem, [p; p], [], 'verify');
  while true
    state.surrogates = fitSurrogates (state.data, problem);
    final = confirmSet (state, problem);
    if final.converged
      break
    end
    state = addRuns (state, problem, p, [], 'replicate');
  end
  r = struct ('runs', final.n, 'converged', true, 'infill', 0, ...
              'verify', final.n, 'probability', final.probability);
end

function report (file)
  [~, cells] = readCsvTable (file);
  ways = {'told', 'form', 'known', 'ours'};
  printf (['| stand-in | told | form known | noise known | ours | form / told | ' ...
           'known / form | ours / form |\n|---|---|---|---|---|---|---|---|\n']);
  for name = unique (cells(:, 1), 'stable')'
    for w = 1:numel (ways)
      isOwn = strcmp (cells(:, 1), name{1}) & strcmp (cells(:, 2), ways{w});
      values = str2double (cells(isOwn, 4:6));
      isRight = all (values(:, 2:3) > 0, 2);
      runs{w} = values(:, 1);
      runs{w}(~isRight) = Inf;
      texts{w} = wayText (runs{w}, sum (isRight), sum (values(:, 2) > 0));
    end
    printf ('| %s | %s | %s | %s | %s | %s | %s | %s |\n', name{1}, texts{:}, ...
            ratioText (runs{2}, runs{1}), ratioText (runs{3}, runs{2}), ...
            ratioText (runs{4}, runs{2}));
  end
end

% Peers state nothing: runs to their own stop where that is right. Without failing
% runs.
function reportPeers (file)
  [header, cells] = readCsvTable (file);
  column = @(name) cells(:, strcmp (header, name));
  isPlain = str2double (column ('fail')) == 0 & ~strcmp (column ('tool'), 'DEcalioc');
  kinds = strcat (column ('standin'), {', '}, column ('tool'));
  for kind = unique (kinds(isPlain), 'stable')'
    own = isPlain & strcmp (kinds, kind{1});
    runs = str2double (column ('runs'))(own);
    isRight = str2double (column ('worst'))(own) < 0.01;
    runs(~isRight) = Inf;
    printf ('%s: %g (%g-%g); %d of %d right\n', kind{1}, ...
            middle (runs, [0.5, 0.25, 0.75]), sum (isRight), numel (runs));
  end
end

% Median (quartiles); of all seeds stated, of them right.
function text = wayText (runs, nRight, nSaid)
  text = '-';
  if ~isempty (runs)
    q = middle (runs, [0.5, 0.25, 0.75]);
    text = sprintf ('%g (%g-%g); %d/%d, %d', q, nSaid, numel (runs), nRight);
  end
end

function text = ratioText (upper, lower)
  text = '-';
  if isempty (upper) || isempty (lower)
    return
  end
  rand ('twister', 1);
  sample = @(x) middle (x(ceil (numel (x) * rand (numel (x), 1))), 0.5);
  ratio = sort (arrayfun (@(k) sample (upper) / sample (lower), 1:2000));
  text = sprintf ('%.2f (%.2f-%.2f)', middle (upper, 0.5) / middle (lower, 0.5), ...
                  ratio([50, 1950]));
end

% quantile interpolates between a number and Inf to NaN.
function q = middle (x, p)
  x = sort (x);
  n = numel (x);
  low = x(max (1, ceil (n * p)));
  high = x(min (n, floor (n * p) + 1));
  q = (low + high) / 2;
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
pkg ('load', 'stk');
pkg ('load', '-nodeps', 'struct', 'optim');
given = argv ();
if strcmp (given{1}, 'report')
  report (given{2});
  reportPeers (fullfile (fileparts (mfilename ('fullpath')), 'results', 'peers.csv'));
else
  measure (given{1}, str2num (given{2}), strsplit (given{3}, ','), given{4});
end
