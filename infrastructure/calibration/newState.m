% NEWSTATE  The state of a calibration between its stages.
%
% CALL: STATE = newState (DATA, SURROGATES, FOUND)
%
% DATA        struct of newData
% SURROGATES  1 x T struct array of fitSurrogates
% FOUND       struct of calibrateOnKriging
% STATE       struct: data, surrogates, found, history (1 x 0 struct: stage,
%             iteration, params, residual T x 1, runs, probability), spent
%             (struct: infill, verify, failed; rows of evaluate), reason,
%             final ([] until confirmSet)
%
% See also: improveByInfill, calibrateOnDEM

function state = newState (data, surrogates, found)
  state.data = data;
  state.surrogates = surrogates;
  state.found = found;
  state.history = struct ('stage', {}, 'iteration', {}, 'params', {}, ...
                          'residual', {}, 'runs', {}, 'probability', {});
  state.spent = struct ('infill', 0, 'verify', 0, 'failed', 0);
  state.reason = '';
  state.final = [];
end
