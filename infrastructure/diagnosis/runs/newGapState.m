% NEWGAPSTATE  The runs of a diagnosis, and how further ones are made.
%
% CALL: STATE = newGapState (DATA, OPTIONS, EVALUATE)
%
%   DATA      of enterRuns, in standard units
%   OPTIONS   of gapOptions: maxNewRuns, verifyRuns
%   EVALUATE  see diagnoseMatrices; [] = none. Or a struct that holds, as the
%             state of addRuns does, evaluate and budget
%   STATE     struct, see addRuns: data, evaluate, budget (its sets are
%             OPTIONS.maxNewRuns), repeats (seeds at each compared set)

function state = newGapState (data, options, evaluate)
  state.data = data;
  if ~isfield (data, 'stage')
    state.data.stage = repmat ({'import'}, rows (data.X), 1);
  end
  % a case brings its budget along; a function handle counts runs alone
  if isstruct (evaluate)
    [state.evaluate, state.budget] = deal (evaluate.evaluate, evaluate.budget);
  else
    [state.evaluate, state.budget] = newEvaluate (evaluate);
  end
  state.budget.sets = options.maxNewRuns;
  state.repeats = options.verifyRuns;
end

%!test
%! data = rmfield (addRows (newData (1, 2, 1), 0.5, [1, 2], 1, 'plan', 0), ...
%!                 'stage');
%! options = struct ('maxNewRuns', 4, 'verifyRuns', 3);
%! state = newGapState (data, options, @(X, E, r) [X, E]);
%! assert ({state.budget.sets, state.repeats, state.data.stage}, ...
%!         {4, 3, {'import'}});
%! assert (newGapState (data, options, state).evaluate, state.evaluate);
%! % nothing may be run
%! assert (isempty (newGapState (data, options, []).evaluate));

% SPDX-License-Identifier: GPL-3.0-only
