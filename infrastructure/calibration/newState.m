% NEWSTATE  The state of a calibration between its stages.
%
% CALL: STATE = newState (DATA [, SURROGATES, FOUND])
%
% DATA        struct of newData
% SURROGATES  1 x T struct array of fitSurrogates (default: none yet)
% FOUND       struct of calibrateOnKriging (default: none yet)
% STATE       struct: data, surrogates, found, history (1 x 0 struct: stage,
%             iteration, params, residual T x 1, ofRuns T x 1, runs,
%             probability: see bookStep), reason,
%             final ([] until confirmSet), evaluate ([] until runs can be
%             made), budget (see newEvaluate), others (see trustLibrary), misled
%             (see keepApart), unjudged (cellstr, see leaveUnjudged), wrong (scalar:
%             sets of the stage on DEM that turned out wrong, see moveTo)

function state = newState (data, surrogates, found)
  if nargin < 2
    [surrogates, found] = deal ([]);
  end
  history = struct ('stage', {}, 'iteration', {}, 'params', {}, ...
                    'residual', {}, 'ofRuns', {}, 'runs', {}, 'probability', {});
  state = struct ('data', data, 'surrogates', surrogates, 'found', found, ...
                  'history', history, 'reason', '', 'misled', '', ...
                  'unjudged', {{}}, 'wrong', 0, 'final', []);
  state.others = struct ('source', {}, 'surrogates', {}, 'search', {});
  [state.evaluate, state.budget] = newEvaluate ([]);
end

%!test
%! state = newState (newData (2, 1));
%! assert ({size(state.data.X), state.surrogates, state.final}, ...
%!         {[0, 2], [], []});
%! assert (budgetLeft (state, smallProblem (1, 0.01)), 40);

% SPDX-License-Identifier: GPL-3.0-only
