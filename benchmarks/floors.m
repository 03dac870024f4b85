% FLOORS  Runs to values that are right and stated right: the floor, and ours.
%
% CALL: octave-cli benchmarks/floors.m STANDIN SEEDS WAYS CSV
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
%     bench, other, half  known, and a form.csv tells how the results follow the
%             parameters: rightly, or wrongly in two ways (storedShape)
%     knownSmall, benchSmall, otherSmall, halfSmall  the same with a plan of d + 1 runs,
%             known2, bench2, other2, half2 with d + 2
%     ours    this calibration
%   CSV      table, to which one row a seed is added; seeds that stand in it are
%            not run again
%
% All else is as the toolbox has it by default. One row: standin, way, seed, runs,
% converged, right, worst (true miss, in tolerances), probability, infill,
% verify, seconds.
%
% See also: calibrateStandIn, learnForm, storedShape, standIn, peers

1;

function measure (name, seeds, ways, file)
  columnsOf = ['standin,way,seed,runs,converged,right,worst,probability,', ...
               'infill,verify,seconds'];
  % handles share no variable; a map is one for all: the form is learnt once
  learnt = containers.Map ('KeyType', 'char', 'ValueType', 'any');
  fillTable (file, columnsOf, {{name}, ways, seeds}, ...
             @(name, way, seed) oneSeed (standIn (name, seed), way, seed, learnt));
end

function sayForm (form, names)
  for t = 1:numel (form)
    f = form(t);
    printf ('%s: %s, %s, bends%s, ranges%s, log density %.3f\n', names{t}, ...
            f.trend, f.covariance, sprintf (' %g', f.limits(4, :)), ...
            sprintf (' %.2f', exp (-f.param(2:end))), f.score);
  end
end

function cells = oneSeed (S, way, seed, learnt)
  started = tic ();
  if strcmp (way, 'told')
    r = confirmTold (S, seed);
    worst = 0;
  else
    if strcmp (way, 'form')
      if ~isKey (learnt, 'form')
        learnt('form') = learnForm (S);
        sayForm (learnt('form'), S.targetNames);
      end
      S.form = learnt('form');
    elseif ~strcmp (way, 'ours')
      S.earlier = 8;
    end
    size_ = regexp (way, '(Small|2)$', 'match', 'once');
    way = regexprep (way, '(Small|2)$', '');
    if ~isempty (size_)
      S.plan = numel (S.names) + 1 + strcmp (size_, '2');
    end
    if any (strcmp (way, {'bench', 'other', 'half'}))
      if ~isKey (learnt, 'shape')
        learnt('shape') = storedShape (S, '');
      end
      S.shape = storedShape (S, strrep (way, 'bench', ''), learnt('shape'));
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

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
pkg ('load', 'stk');
pkg ('load', '-nodeps', 'struct', 'optim');
given = argv ();
measure (given{1}, str2num (given{2}), strsplit (given{3}, ','), given{4});

% SPDX-License-Identifier: GPL-3.0-only
