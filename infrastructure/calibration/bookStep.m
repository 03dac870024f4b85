% BOOKSTEP  Appends the present set to the history of a calibration.
%
% CALL: STATE = bookStep (STATE, STAGE, ITERATION)
% CALL: STATE = bookStep (STATE, STAGE, ITERATION, SAY)
%
% STATE      struct of newState
% STAGE      'infill' or 'DEM'; ITERATION  integer
% SAY        handle, gets a line: stage, sets since the plan, residuals and
%            probability

function state = bookStep (state, stage, iteration, say)
  found = state.found;
  T = numel (state.surrogates);
  step = struct ('stage', stage, 'iteration', iteration, ...
                 'params', found.params, 'residual', found.residual(1:T), ...
                 'runs', sum (isAfterPlan (state.data)), ...
                 'probability', found.probability);
  state.history(end + 1) = step;
  if nargin > 3
    say (sprintf ('%s %d: %d runs, residuals (%%)%s, probability %.2f', ...
                  step.stage, step.iteration, step.runs, ...
                  residualText (step.residual, ' %.2f'), step.probability));
  end
end

%!test
%! [~, state] = smallCalibration ();
%! state.found.residual = [0.01; -0.02];
%! state.found.probability = 0.5;
%! file = tempname ();
%! state = bookStep (state, 'DEM', 2, @(text) writeAtomic (file, text));
%! said = fileread (file);
%! delete (file);
%! assert (said, 'DEM 2: 0 runs, residuals (%) 1.00 -2.00, probability 0.50');
%! assert (state.history.iteration, 2);
