% PLANSTUDY  Whole diagnoses of foreign laboratories: sets, verdict, truth.
%
% CALL: octave-cli benchmarks/planStudy.m KIND NUMBERS NEUTRAL CSV
%
%   KIND     blind: the laboratories of foreignLab
%   NUMBERS  laboratories, e.g. 101:130: one case each
%   NEUTRAL  neutral sets that are there, for each parameter and one (at most
%            40): what completePlan makes of an empty store
%   CSV      table, to which one row a case is added; cases that stand in it are
%            not made again
%
% A case is drawn from its number: of ten 6 have one effect, 1 two, 1 an effect
% that is taken off the list, 2 no gap; d of the measurement (twinsDraw, without
% the surrogates) is 4 to 10. The diagnosis makes its own runs, as many as
% foreseeSets counts, as a case would; sets are all of them, those that verify
% and the neutral ones too. For an earlier plan this file is run in a worktree
% of an earlier commit.
%
% See also: foreignLab, exploreEffects

1;

function runStudy (kind, numbers, neutral, file)
  addpath (fileparts (mfilename ('fullpath')));
  startBenchmarks ();
  pkg ('load', 'stk');
  fillTable (file, ['kind,number,laboratory,parameters,targets,effects,class,truth,', ...
                    'd,strength,neutral,sets,failed,verdict,said,guard,lookAlike,', ...
                    'outcome,seconds'], {{kind}, numbers}, ...
             @(~, number) oneCase (number, neutral));
end

function cells = oneCase (number, neutral)
  lab = foreignLab (number);
  rand ('twister', 300000 + number);
  randn ('twister', 300000 + number);
  twin = drawCase (lab, number);
  p = columns (lab.problem.limits);
  n0 = min (neutral * (p + 1), 40);
  data = lab.plan (n0, 0);
  given = setfield (lab.problem, 'value', twin.y);
  kept = setdiff (1:numel (given.effects), twin.removed);
  dem = find (~[given.effects.laboratory]);
  data.E = data.E(:, ismember (dem, kept));
  given.effects = given.effects(kept);
  start = cputime ();
  d = diagnoseLab (given, data, runsOfLab (lab.run, given, kept));
  seconds = cputime () - start;
  names = {lab.problem.effects.name};
  cells = {lab.name, p, numel(twin.y), numel(dem), ...
           twin.class, strjoin(names(twin.cause), ' '), twin.d, ...
           num2str(twin.phi(twin.cause)), n0, n0 + d.runs.spent, ...
           d.runs.failed, d.which.verdict, strjoin(d.which.effects, ' '), ...
           d.which.guard, d.which.lookAlike, ...
           outcomeOf(twin, d.which, names(twin.cause)), seconds};
end

% Strong enough to be seen: effects that reach the level come first.
function twin = drawCase (lab, number)
  K = numel (lab.problem.effects);
  p = columns (lab.problem.limits);
  classes = {'single', 'null', 'single', 'pair', 'single', 'single', 'off', ...
             'null', 'single', 'single'};
  levels = [4, 5, 6, 8, 10, 5, 4];
  turn = 7 * floor (number / 4) + 3 * mod (number, 4);
  twin = struct ('class', classes{1 + mod(turn, 10)}, 'cause', ...
                 zeros (1, 0), 'removed', 0, 'phi', zeros (1, K), ...
                 'theta', 0.1 + 0.8 * rand (1, p), 'd', 0, 'y', []);
  lab.noise = sqrt (lab.noiseSd.^2 + lab.problem.sd.^2);
  space = twinsSpace (lab, twin.theta);
  level = levels(1 + mod (number, 7));
  order = randperm (K);
  order = strongFirst (order, lab, space, twin.theta, level);
  if strcmp (twin.class, 'off')
    order = order(~[lab.problem.effects(order).laboratory]);
    twin.removed = order(1);
  end
  count = struct ('null', 0, 'single', 1, 'off', 1, 'pair', 2);
  twin.cause = sort (order(1:count.(twin.class)));
  for k = twin.cause
    twin.phi(k) = twinsStrength (lab, space, k, level);
  end
  twin.d = space.visible (lab.means (twin.theta, twin.phi) - space.base);
  twin.y = lab.measure (twin.theta, twin.phi);
end

% All runs that a plan makes; nothing is calibrated on twins.
function d = diagnoseLab (given, data, runs)
  options = gapOptions ([]);
  options.maxNewRuns = foreseeSets (newProblem (given).effects, 1e4, options);
  options.bootstrap = 99;
  d = diagnoseMatrices (given, data, options, runs);
end

% Further runs of a laboratory, with the effects KEPT alone, as diagnoseMatrices asks:
% Z = RUNS (X, E, ...), parameters and values of the effects.
function runs = runsOfLab (run, given, kept)
  given.value = zeros (size (given.sd));
  effects = newProblem (given).effects;
  low = given.limits(1, :);
  among = eye (max ([kept, numel(effects)]))(kept, :);
  runs = @(X, E, varargin) run ((X - low) ./ diff (given.limits), ...
                                strengthOfValues (effects, E) * among);
end

% Those that can be seen well enough come first; else the order is kept.
function order = strongFirst (order, lab, space, theta, level)
  K = numel (order);
  reach = space.visible (lab.means (ones (K, 1) * theta, eye (K)) - ...
                         space.base)';
  order = [order(reach(order) >= level), order(reach(order) < level)];
end

% Said rightly or not, by what a user would do with it.
function word = outcomeOf (twin, which, truth)
  said = which.effects;
  isName = strcmp (which.verdict, 'named');
  isSaid = isName || strcmp (which.verdict, 'group');
  if any (strcmp (twin.class, {'null', 'off'}))
    truth = {};
  end
  if ~isSaid
    word = 'nothing';
    if strcmp (which.verdict, 'none of the listed')
      word = 'unlisted';
    end
  elseif isName && all (ismember (said, truth))
    word = 'named';
  elseif ~isName && any (ismember (said, truth))
    word = 'grouped';
  elseif isName
    word = 'wrong';
  else
    word = 'wrong group';
  end
end

args = argv ();
runStudy (args{1}, str2num (args{2}), str2double (args{3}), args{4});

% SPDX-License-Identifier: GPL-3.0-only
