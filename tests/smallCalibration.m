% SMALLCALIBRATION  A small calibration under way, for tests of its blocks.
%
% CALL: [PROBLEM, STATE, SURROGATES] = smallCalibration ()
%
%   PROBLEM     struct of newProblem: 2 parameters, 2 targets, met at [0.5, 1]
%   STATE       struct of newState: 12 plan runs with 0.3 % scatter, their
%               surrogates, the set [0.5, 1] found
%   SURROGATES  1 x 2 struct array of fitSurrogates
%
% Leaves the random generators where the plan has left them (seed 2).
%
% See also: standInCase

function [problem, state, surrogates] = smallCalibration ()
  pkg ('load', 'stk');
  pkg ('load', '-nodeps', 'struct', 'optim');
  rand ('twister', 2);
  randn ('twister', 2);
  C = struct ('names', {{'a', 'b'}}, 'limits', [0, 0; 1, 2]);
  C.targets = struct ('name', {'x', 'y'}, 'value', {4, 2}, 'tol', 0.02);
  problem = newProblem (C, []);
  X = rand (12, 2) .* [1, 2];
  Z = [3 + X(:, 1) + X(:, 2) / 2, 1 + X(:, 1) + X(:, 2) / 2.5];
  data = addRows (newData (2, 2), X, Z .* (1 + 0.003 * randn (12, 2)), ...
                  ones (12, 1), 'plan');
  surrogates = fitSurrogates (data, problem);
  state = newState (data, surrogates, ...
                    describeSet (surrogates, problem, [0.5, 1]));
  state.found.conflict = {};
end
