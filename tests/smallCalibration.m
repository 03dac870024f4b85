% SMALLCALIBRATION  A small calibration under way, for tests of its blocks.
%
% CALL: [PROBLEM, STATE, SURROGATES, LAW] = smallCalibration ()
%
%   PROBLEM     struct of newProblem: 2 parameters, 2 targets, met at [0.5, 1]
%   STATE       struct of newState: 12 plan runs with 0.3 % scatter, their
%               surrogates, the set [0.5, 1] found; further runs follow the law
%   SURROGATES  1 x 2 struct array of fitSurrogates
%   LAW         handle P n x 2 -> Z n x 2, what the runs scatter about
%
% Leaves the random generators where the plan has left them (seed 2).
%
% See also: standInCase

function [problem, state, surrogates, law] = smallCalibration ()
  pkg ('load', 'stk');
  pkg ('load', '-nodeps', 'struct', 'optim');
  rand ('twister', 2);
  randn ('twister', 2);
  C = struct ('names', {{'a', 'b'}}, 'limits', [0, 0; 1, 2]);
  C.targets = struct ('name', {'x', 'y'}, 'value', {4, 2}, 'tol', 0.02);
  problem = newProblem (C, []);
  X = rand (12, 2) .* [1, 2];
  law = @(P) [3 + P(:, 1) + P(:, 2) / 2, 1 + P(:, 1) + P(:, 2) / 2.5];
  data = addRows (newData (2, 2), X, law (X) .* (1 + 0.003 * randn (12, 2)), ...
                  ones (12, 1), 'plan');
  surrogates = fitSurrogates (data, problem);
  state = newState (data, surrogates, ...
                    describeSet (surrogates, problem, [0.5, 1]));
  state.found.conflict = {};
  state.evaluate = newEvaluate (@(P, E, r) law (P));
end

% SPDX-License-Identifier: GPL-3.0-only
