% BOOKSTEP  Appends the present set to the history of a calibration.
%
% CALL: STATE = bookStep (STATE, STAGE, ITERATION [, SAY])
%
% STAGE  'infill' or 'DEM'; ITERATION  integer; SAY  gets a line about the step

function state = bookStep (state, stage, iteration, say)
  found = state.found;
  residual = found.residual(1:numel (state.surrogates));
  runs = sum (isAfterPlan (state.data));
  state.history(end + 1) = struct ('stage', stage, 'iteration', iteration, ...
                                   'params', found.params, ...
                                   'residual', residual, 'runs', runs, ...
                                   'probability', found.probability);
  if nargin > 3
    say (sprintf ('%s %d: %s, residuals (%%)%s, probability %.2f', ...
                  stage, iteration, countText (runs, 'run'), ...
                  residualText (residual, {state.surrogates.name}), ...
                  found.probability));
  end
end

%!test
%! [~, state] = smallCalibration ();
%! state.found.residual = [0.01; -0.02];
%! state.found.probability = 0.5;
%! said = evalc ('state = bookStep (state, ''DEM'', 2, @disp);');
%! assert (said, ["DEM 2: 0 runs, residuals (%) y -2, x 1, " ...
%!                "probability 0.50\n"]);
%! assert (state.history.iteration, 2);
