% SAYSTEP  One line of text about the last step of a calibration.
%
% CALL: text = sayStep (state)
%
% See also: bookStep

function text = sayStep (state)
  step = state.history(end);
  text = sprintf ('%s %d: %d runs, residuals%s %%, probability %.2f', ...
                  step.stage, step.iteration, step.runs, ...
                  residualText (step.residual, ' %.2f'), step.probability);
end

%!shared problem, state, s
%! pkg load stk
%! pkg load -nodeps struct optim
%! rand ('twister', 2);
%! randn ('twister', 2);
%! C = struct ('names', {{'a', 'b'}}, 'limits', [0, 0; 1, 2]);
%! C.targets = struct ('name', {'x', 'y'}, 'value', {4, 2}, 'tol', 0.02);
%! problem = newProblem (C, []);
%! X = rand (12, 2) .* [1, 2];
%! Z = [3 + X(:, 1) + X(:, 2) / 2, 1 + X(:, 1) + X(:, 2) / 2.5];
%! data = addRows (newData (2, 2), X, Z .* (1 + 0.003 * randn (12, 2)), ...
%!                 ones (12, 1), 'plan');
%! s = fitSurrogates (data, problem);
%! state = newState (data, s, describeSet (s, problem, [0.5, 1]));
%! state.found.conflict = {};

%!test
%! state.found.residual = [0.01; -0.02];
%! state.found.probability = 0.5;
%! state = bookStep (state, 'DEM', 2);
%! assert (sayStep (state), ...
%!         'DEM 2: 0 runs, residuals 1.00 -2.00 %, probability 0.50');
