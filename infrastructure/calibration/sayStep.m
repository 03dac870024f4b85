% SAYSTEP  One line of text about the last step of a calibration.
%
% CALL: TEXT = sayStep (STATE)
%
% STATE  struct of newState
% TEXT   stage, sets since the plan, residuals and probability
%
% See also: bookStep

function text = sayStep (state)
  step = state.history(end);
  text = sprintf ('%s %d: %d runs, residuals (%%)%s, probability %.2f', ...
                  step.stage, step.iteration, step.runs, ...
                  residualText (step.residual, ' %.2f'), step.probability);
end

%!shared problem, state, s
%! [problem, state, s] = smallCalibration ();

%!test
%! state.found.residual = [0.01; -0.02];
%! state.found.probability = 0.5;
%! state = bookStep (state, 'DEM', 2);
%! assert (sayStep (state), ...
%!         'DEM 2: 0 runs, residuals (%) 1.00 -2.00, probability 0.50');
