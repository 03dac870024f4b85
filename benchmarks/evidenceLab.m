% EVIDENCELAB  How often 90 % intervals hold the truth: parameters, held-out results.
%
% CALL: octave-cli benchmarks/evidenceLab.m LAB CORRELATION SEEDS CSV
%
%   LAB          parameters: five readings of one packing, of a bench of one parameter
%                and 20 runs; heldOut: of a + b and a - b, 16 runs, a + b is fitted and
%                a - b predicted, the truth anywhere within the limits; heldOutInner: in
%                their inner half, where every value of a + b leaves a - b wider than
%                the truths are
%   CORRELATION  of the scatter of the readings, and of the results of a run
%   SEEDS        e.g. 1:100: each another truth, plan and scatter
%   CSV          table, to which one row a seed is added: lab, correlation, seed, holds
%                (1, 0), width (of parameters in parts of the limits); seeds that stand
%                in it are not made again
%
1;

function cells = oneCase (lab, correlation, seed)
  rand ('twister', 1000 + seed);
  randn ('twister', 1000 + seed);
  labs = struct ('parameters', @ofParameters, 'heldOut', @(s) ofHeldOut (s, rand (1, 2)), ...
                 'heldOutInner', @(s) ofHeldOut (s, 0.25 + 0.5 * rand (1, 2)));
  scatter = @(n, T) sqrt (correlation) * randn (n, 1) + ...
                    sqrt (1 - correlation) * randn (n, T);
  [holds, width] = labs.(lab) (scatter);
  cells = {holds, width};
end

function [holds, width] = ofParameters (scatter)
  slope = [1, 1.2, 0.9, 1.1, 1];
  truth = 0.2 + 0.6 * rand ();
  plan = ((1:20)' - 0.5) / 20;
  law = @(X) 3 + X * slope + 0.1 * scatter (rows (X), 5);
  given = struct ('names', {{'a'}}, 'limits', [0; 1], 'targets', ...
                  struct ('value', num2cell (law (truth)), 'tol', 0.02, 'trials', 1));
  problem = newProblem (given, []);
  data = addRows (newData (1, 5), plan, law (plan), ones (20, 1), 'plan');
  known = parameterPosterior (fitSurrogates (data, problem), problem);
  holds = truth >= known.interval90(1) && truth <= known.interval90(2);
  width = diff (known.interval90);
end

function [holds, width] = ofHeldOut (scatter, truth)
  law = @(X) 5 + [X(:, 1) + X(:, 2), X(:, 1) - X(:, 2)] + 0.02 * scatter (rows (X), 2);
  plan = rand (16, 2);
  value = law (truth);
  given = struct ('names', {{'a', 'b'}}, 'limits', [0, 0; 1, 1], 'targets', ...
                  struct ('value', num2cell (value), 'tol', 0.02, 'role', ...
                          {'calibrate', 'holdout'}));
  problem = newProblem (given, []);
  data = addRows (newData (2, 2), plan, law (plan), ones (16, 1), 'plan');
  surrogates = fitSurrogates (data, problem);
  state = newState (data, surrogates, calibrateOnKriging (surrogates, problem));
  state.found.conflict = {};
  state.final = confirmSet (state, problem);
  state.final.untested = [];
  c = newCalibration (state, problem, struct ('models', 1));
  holds = c.holdout.inside;
  width = diff (c.holdout.interval90);
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
args = argv ();
fillTable (args{4}, 'lab,correlation,seed,holds,width', ...
           {args(1), str2double(args{2}), str2num(args{3})}, @oneCase);

% SPDX-License-Identifier: GPL-3.0-only
