% READINGSLAB  What a change is said to be, from readings of a rig and of a change.
%
% CALL: octave-cli benchmarks/readingsLab.m CSV SEEDS SETTING...
%
%   CSV      table, to which one row a seed and setting is added
%   SEEDS    e.g. 1:5, of 20 cases each
%   SETTING  lines-after-sessions-paired-ratio-unequal-packings-strength-way, such
%            as 2-2-0-0-0-0-0.3-0-read:
%     lines, after  readings of the reference and of the change, each session
%     sessions  of each (0: none is named, and they do not differ)
%     paired    1: those of the reference and of the change are the same
%     ratio     standard deviation between sessions over that of a trial
%     unequal   1: trials of different quantities scatter differently (deviation
%               of the logarithm), 0: alike
%     packings  scatter of a run over that of a trial
%     strength  of the first of two causes in the change (0: nothing has changed)
%     way       read: as measured.csv is read; known: uncertainties are told
%
% Six quantities, one parameter, two causes. Of each case: is there an alarm (p of
% the gate below 0.05), is one cause more than 90 % probable (Laplace), is it the
% right one.

1;

function measure (file, seeds, text)
  columnsOf = ['setting,seed,cases,alarms,named,right,inSd,readings'];
  [done, counted] = startTable (file, columnsOf, 2);
  values = strsplit (text, '-');
  names = {'lines', 'after', 'sessions', 'paired', 'ratio', 'unequal', ...
           'packings', 'strength'};
  s = cell2struct (num2cell (str2double (values(1:8))), names, 2);
  s.way = values{9};
  for seed = seeds
    if ~any (strcmp (done, sprintf ('%s,%d', text, seed)))
      counts = oneSeed (s, seed, 20);
      appendLine (file, rowText ([{text, seed, 20}, num2cell(counts)]));
    end
  end
end

function counts = oneSeed (s, seed, cases)
  rand ('twister', seed);
  randn ('twister', seed);
  lab = laboratory (s);
  counts = zeros (1, 5);
  for i = 1:cases
    [problem, z] = oneProblem (s, lab);
    emulator = emulateChange (lab.emulator, problem);
    hypotheses = makeHypotheses (problem, emulator, lab.options);
    fits = fitLibrary (hypotheses, problem.value);
    statistic = gapTest (hypotheses, fits.logE).statistic;
    hypotheses = gapReference (hypotheses, statistic);
    gate = gapTest (hypotheses, fits.logE);
    P = log ([hypotheses.list.prior]) + fits.logE;
    P = exp (P - logSumExp (P))(hypotheses.singles);
    isNamed = max (P) > 0.9;
    counts = counts + [gate.p < 0.05, isNamed, isNamed && P(1) > 0.9, ...
                       sum(abs (z) < 1), numel(z)];
  end
end

function lab = laboratory (s)
  S = [3, 1, 0, -1, 2, 0.5];
  F = [0, 2, 4, 1, -2, 3; 3, -2, 0, 3, 2, -3];
  lab.means = @(X, phi) 20 + (2 * X - 1) * S + phi * F;
  T = numel (S);
  names = {'a', 'b'};
  for k = 1:2
    effects(k) = struct ('name', names{k}, 'variables', {{['v', names{k}]}}, ...
                         'neutral', 0, 'limits', [0.1; 1], 'laboratory', ...
                         false, 'offset', []);
  end
  lab.given = struct ('value', 20 * ones (1, T), 'sd', ones (1, T), ...
                      'limits', [0; 1], 'bench', ones (1, T), 'effects', effects);
  X = [linspace(0, 1, 12)'; rand(16, 1)];
  own = (1:8)' / 8;
  data.X = X;
  data.E = [zeros(12, 2); own, zeros(8, 1); zeros(8, 1), own];
  data.Z = lab.means (X, data.E) + s.packings * randn (28, T);
  data.replicate = ones (28, 1);
  lab.options = gapOptions (struct ('trend', 'affine', 'twins', 200));
  lab.emulator = fitEmulator (newProblem (lab.given), data, lab.options);
end

% Z: change over its standard uncertainty, less what was put in.
function [problem, z] = oneProblem (s, lab)
  T = numel (lab.given.value);
  sd = exp (s.unequal * randn (1, T));
  mean_ = rand ();
  list = [];
  for state = 0:1
    n = s.lines * (state == 0) + s.after * (state == 1);
    for k = 1:max (s.sessions, 1)
      if state == 0 || ~s.paired
        days{k} = s.ratio * sd .* randn (1, T) * (s.sessions > 0);
      end
      values = lab.means (mean_, [s.strength * state, 0]) + days{k} + ...
               sd .* randn (n, T);
      list = [list, linesOf(s, state, k, values)];
    end
  end
  [groups, ~, conditions] = groupMeasured (list, {'A'});
  Case = struct ('names', {{'mu'}}, 'limits', [0; 1], 'targets', groups, ...
                 'conditions', {conditions}, 'perCondition', false);
  own = newProblem (Case, [], 1);
  problem = lab.given;
  for name = {'value', 'sd', 'sdKnown', 'trials', 'scatter', 'shared', ...
              'freedom', 'commonFreedom', 'sessionFreedom'}
    problem.(name{1}) = own.(name{1});
  end
  problem.reference = own.reference;
  if strcmp (s.way, 'known')
    problem = told (problem, s, sd);
  end
  problem = newProblem (problem);
  reference = problem.reference;
  added = lab.means (mean_, [s.strength, 0]) - lab.means (mean_, [0, 0]);
  z = (problem.value - reference.value - added) ./ ...
      sqrt (problem.sd.^2 + reference.sd.^2 - 2 * diag (reference.together)');
end

function list = linesOf (s, state, k, values)
  session = '';
  if s.sessions > 0
    session = sprintf ('day%d%d', k, state * ~s.paired);
  end
  list = struct ('line', 2, 'model', 1, 'name', '', 'series', '', 'unit', '', ...
                 'at', NaN, 'value', num2cell (values(:)'), 'sd', 0, 'repeats', ...
                 NaN, 'role', 'calibrate', 'tol', 0.1, 'isAbsolute', false, ...
                 'condition', {{'reference', 'now'}{state + 1}}, 'file', '', ...
                 'session', session);
  names = arrayfun (@(t) sprintf ('q%d', t), 1:columns (values), ...
                    'UniformOutput', false);
  names = repmat (names, rows (values), 1);
  [list.name] = names{:};
end

function problem = told (problem, s, sd)
  n = [s.lines, s.after] * max (s.sessions, 1);
  between = (s.sessions > 0) * s.ratio^2 / max (s.sessions, 1);
  problem.shared = sd * sqrt (between);
  problem.sd = sd * sqrt (1 / n(2) + between);
  problem.reference.shared = problem.shared;
  problem.reference.sd = sd * sqrt (1 / n(1) + between);
  problem.reference.together = diag (problem.shared.^2) * (s.paired > 0);
  for name = {'freedom', 'commonFreedom', 'sessionFreedom'}
    [problem.(name{1}), problem.reference.(name{1})] = deal (Inf (size (sd)));
  end
  problem.sdKnown = true (size (sd));
  [problem.scatter, problem.reference.scatter] = deal (true (size (sd)));
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
warning ('off', 'all');
args = argv ();
for k = 3:numel (args)
  measure (args{1}, eval (args{2}), args{k});
end
