% NEWSTATE  The state of a calibration between its stages.
%
% CALL: STATE = newState (DATA, SURROGATES, FOUND)
%
% DATA        struct of newData
% SURROGATES  1 x T struct array of fitSurrogates (default: none yet)
% FOUND       struct of calibrateOnKriging (default: none yet)
% STATE       struct: data, surrogates, found, history (1 x 0 struct: stage,
%             iteration, params, residual T x 1, runs, probability), reason,
%             final ([] until confirmSet), evaluate ([] until runs can be
%             made), budget (see newEvaluate), misled (see trustLibrary)

function state = newState (data, surrogates, found)
  state.data = data;
  [state.surrogates, state.found] = deal ([]);
  if nargin > 1
    state.surrogates = surrogates;
    state.found = found;
  end
  state.history = struct ('stage', {}, 'iteration', {}, 'params', {}, ...
                          'residual', {}, 'runs', {}, 'probability', {});
  [state.reason, state.misled] = deal ('');
  state.final = [];
  [state.evaluate, state.budget] = newEvaluate ([]);
end
