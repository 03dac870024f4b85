% READINGSLAB  What a change is said to be, from readings of a rig and of a change.
%
% CALL: octave-cli benchmarks/readingsLab.m CSV SEEDS SETTING...
%
%   CSV      table, to which one row a seed and setting is added
%   SEEDS    e.g. 1:5, of 20 cases each; those that stand in CSV are not made again
%   SETTING  lines-after-sessions-paired-ratio-unequal-blocks-noise-packings-fine-lack-strength-way,
%            such as 2-2-0-0-0-0-1-normal-0.3-1-0.1-0-read:
%     lines, after  readings of the reference and of the change, each session (after
%               0: none, the rig is held against its simulation)
%     sessions  of each (0: none is named, and they do not differ)
%     paired    1: those of the reference and of the change are the same
%     ratio     standard deviation between sessions over that of a trial
%     unequal   deviation of the logarithm of the scatter of different quantities
%     blocks    readings of each filling, which scatter as fillings do (column
%               block; 1: each reading is one of its own)
%     noise     normal, or odd: trials are skewed (gamma, skewness 1), sessions
%               have long tails (Laplace)
%     packings  scatter of a run over that of a trial
%     fine      by what parameter and causes move readings more (1: up to six times
%               the scatter of a trial)
%     lack      what the simulation misses of each quantity, in both states alike,
%               at most: uniform to either side, over what the parameter moves
%     strength  of the first of two causes in the change (0: nothing has changed)
%     way       read: as measured.csv is read; known: uncertainties are told;
%               each: as read, without a diagnosis
%
% Six quantities, one parameter, two causes. Of each case: is there an alarm (p of
% the gate below 0.05), is one cause more than 90 % probable (Laplace), is it the
% right one. Of each reading: is its change, less what was put in, within one sd
% of sdOfChange, is its p (Student's t) below 0.05; is its scatter, which never
% changes, said to have (p below 0.01, of how many that had trials enough).

1;

function measure (file, seeds, text)
  columnsOf = ['setting,seed,cases,alarms,named,right,inSd,below5,readings,', ...
               'scatters,ofScatter'];
  values = strsplit (text, '-');
  names = {'lines', 'after', 'sessions', 'paired', 'ratio', 'unequal', ...
           'blocks', 'noise', 'packings', 'fine', 'lack', 'strength', ...
           'way'};
  isText = ismember (names, {'noise', 'way'});
  values(~isText) = num2cell (str2double (values(~isText)));
  s = cell2struct (values, names, 2);
  fillTable (file, columnsOf, {{text}, seeds}, ...
             @(~, seed) [{20}, num2cell(oneSeed (s, seed, 20))]);
end

function counts = oneSeed (s, seed, cases)
  for generator = {@rand, @randn, @randg, @rande}
    generator{1} ('twister', seed);
  end
  lab = laboratory (s);
  counts = zeros (1, 8);
  for i = 1:cases
    [problem, z, p, ofScatter] = oneProblem (s, lab);
    counts(4:6) = counts(4:6) + [sum(abs (z) < 1), sum(p < 0.05), numel(z)];
    counts(7:8) = counts(7:8) + [sum(ofScatter < 0.01), sum(~isnan (ofScatter))];
    if ~strcmp (s.way, 'each')
      counts(1:3) = counts(1:3) + verdictOf (problem, lab);
    end
  end
end

% Whether there is an alarm, a name, the right one.
function is = verdictOf (problem, lab)
  emulator = emulateChange (lab.emulator, newProblem (problem));
  hypotheses = makeHypotheses (problem, emulator, lab.options);
  fits = fitLibrary (hypotheses, problem.value);
  statistic = gapTest (hypotheses, fits.logE).statistic;
  hypotheses = gapReference (hypotheses, statistic);
  gate = gapTest (hypotheses, fits.logE);
  P = log ([hypotheses.list.prior]) + fits.logE;
  P = exp (P - logSumExp (P))(hypotheses.singles);
  isNamed = max (P) > 0.9;
  is = [gate.p < 0.05, isNamed, isNamed && P(1) > 0.9];
end

function lab = laboratory (s)
  S = [3, 1, 0, -1, 2, 0.5];
  F = [0, 2, 4, 1, -2, 3; 3, -2, 0, 3, 2, -3];
  lab.means = @(X, phi) 20 + s.fine * ((2 * X - 1) * S + phi * F);
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
  if strcmp (s.way, 'each')
    return
  end
  lab.emulator = fitEmulator (newProblem (lab.given), data, lab.options);
end

% Z: change over its standard uncertainty, less what was put in.
function [problem, z, p, ofScatter] = oneProblem (s, lab)
  T = numel (lab.given.value);
  sd = exp (s.unequal * randn (1, T));
  mean_ = rand ();
  span = abs (lab.means (1, [0, 0]) - lab.means (0, [0, 0]));
  lack = s.lack * span .* (2 * rand (1, T) - 1);
  list = [];
  for state = 0:min (s.after, 1)
    n = s.lines * (state == 0) + s.after * (state == 1);
    for k = 1:max (s.sessions, 1)
      if state == 0 || ~s.paired
        days{k} = s.ratio * sd .* drawDays (s, T) * (s.sessions > 0);
      end
      values = lab.means (mean_, [s.strength * state, 0]) + lack + days{k} + ...
               sd .* drawTrials (s, n, T);
      list = [list, linesOf(s, state, k, values)];
    end
  end
  [groups, ~, conditions] = groupMeasured (list, {'A'});
  problem = lab.given;
  [z, p, ofScatter] = deal (zeros (1, 0));
  if s.after > 0
    added = lab.means (mean_, [s.strength, 0]) - lab.means (mean_, [0, 0]);
    [z, p] = arrayfun (@changeOf, groups, added);
    ofScatter = arrayfun (@(g) g.changed.scatterP, groups);
  end
  if strcmp (s.way, 'each')
    return
  end
  problem = asRead (s, problem, groups, conditions);
  if strcmp (s.way, 'known')
    problem = told (problem, s, sd);
  end
  problem = newProblem (problem);
end

% Over its standard uncertainty, less what was put in; chance of one as large.
function [z, p] = changeOf (group, added)
  [sd, freedom] = sdOfChange (group, group.changed);
  z = (group.changed.value - group.value - added) / sd;
  t = z * studentFactor (freedom);
  p = betainc (freedom / (freedom + t^2), freedom / 2, 0.5);
  if freedom > 1e4
    p = 2 * normalTail (abs (t));
  end
end

% Of unit variance; readings of a filling scatter about it as fillings do.
function e = drawTrials (s, n, T)
  e = drawOf (s, n, T);
  if s.blocks > 1
    e = kron (e, ones (s.blocks, 1)) + drawOf (s, n * s.blocks, T);
  end
end

function e = drawOf (s, n, T)
  if strcmp (s.noise, 'normal')
    e = randn (n, T);
  else
    e = (randg (4 * ones (n, T)) - 4) / 2;
  end
end

function e = drawDays (s, T)
  e = randn (1, T);
  if ~strcmp (s.noise, 'normal')
    e = sign (rand (1, T) - 0.5) .* rande (1, T) / sqrt (2);
  end
end

function problem = asRead (s, problem, groups, conditions)
  Case = struct ('names', {{'mu'}}, 'limits', [0; 1], 'targets', groups, ...
                 'conditions', {conditions}, 'perCondition', false);
  own = newProblem (Case, [], 1);
  for name = {'value', 'sd', 'sdKnown', 'trials', 'scatter', 'shared', ...
              'freedom', 'commonFreedom', 'sessionFreedom', 'reference'}
    problem.(name{1}) = own.(name{1});
  end
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
  [list.block] = deal ('');
  if s.blocks > 1
    fillings = arrayfun (@(k) sprintf ('f%d', k), ceil ((1:rows (values))' / s.blocks), ...
                         'UniformOutput', false);
    fillings = repmat (fillings, 1, columns (values));
    [list.block] = fillings{:};
  end
end

function problem = told (problem, s, sd)
  n = [s.lines, s.after] * max (s.sessions, 1);
  trial = sd * sqrt (1 + (s.blocks > 1) / s.blocks);
  between = (s.sessions > 0) * s.ratio^2 / max (s.sessions, 1);
  now = n(1 + (s.after > 0));
  problem.shared = sd * sqrt (between);
  problem.sd = hypot (trial / sqrt (now), problem.shared);
  for name = {'freedom', 'commonFreedom', 'sessionFreedom'}
    problem.(name{1}) = Inf (size (sd));
  end
  problem.sdKnown = true (size (sd));
  problem.scatter = true (size (sd));
  if s.after > 0
    reference = problem.reference;
    for name = {'shared', 'freedom', 'commonFreedom', 'sessionFreedom', 'scatter'}
      reference.(name{1}) = problem.(name{1});
    end
    reference.sd = hypot (trial / sqrt (n(1)), problem.shared);
    reference.together = diag (problem.shared.^2) * (s.paired > 0);
    problem.reference = reference;
  end
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
warning ('off', 'all');
args = argv ();
for k = 3:numel (args)
  measure (args{1}, eval (args{2}), args{k});
end

% SPDX-License-Identifier: GPL-3.0-only
