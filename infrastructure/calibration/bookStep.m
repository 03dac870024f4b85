% BOOKSTEP  Appends the present set to the history of a calibration.
%
% CALL: STATE = bookStep (STATE, STAGE, ITERATION)
%
% STATE      struct of newState
% STAGE      'infill' or 'DEM'; ITERATION  integer
%
% See also: newState, sayStep

function state = bookStep (state, stage, iteration)
  found = state.found;
  T = numel (state.surrogates);
  step = struct ('stage', stage, 'iteration', iteration, ...
                 'params', found.params, 'residual', found.residual(1:T), ...
                 'runs', state.spent.infill + state.spent.verify, ...
                 'probability', found.probability);
  state.history(end + 1) = step;
end
