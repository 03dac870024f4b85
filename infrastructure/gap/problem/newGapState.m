% NEWGAPSTATE  The runs of a diagnosis, and how further ones are made.
%
% CALL: STATE = newGapState (DATA, GAPPROBLEM, OPTIONS, EVALUATE)
%
%   DATA        of enterRuns, in standard units
%   GAPPROBLEM  of enterRuns: kept and unit are read
%   OPTIONS     of gapOptions: maxNewRuns, verifyRuns
%   EVALUATE    see diagnoseMatrices; [] = none. Or a struct that holds, as the
%               state of addRuns does, evaluate and budget
%   STATE       struct, see addRuns: data, budget, evaluate (its Z in standard
%               units); left (sets that may still be run: one that fails was run
%               twice, see runJobs), spent, failed, repeats (seeds at each
%               compared set)

function state = newGapState (data, gapProblem, options, evaluate)
  if isstruct (evaluate)
    runs = evaluate;
  else
    [runs.evaluate, runs.budget] = newEvaluate (evaluate);
  end
  state = struct ('data', data, 'budget', runs.budget, 'evaluate', [], ...
                  'left', options.maxNewRuns, 'spent', 0, 'failed', 0, ...
                  'repeats', options.verifyRuns);
  if ~isfield (data, 'stage')
    state.data.stage = repmat ({'import'}, rows (data.X), 1);
  end
  if ~isempty (runs.evaluate)
    state.evaluate = @(varargin) inStandardUnits (runs.evaluate, gapProblem, ...
                                                  varargin{:});
  end
end

function [Z, budget] = inStandardUnits (evaluate, gapProblem, varargin)
  [Z, budget] = evaluate (varargin{:});
  Z = Z(:, gapProblem.kept) ./ gapProblem.unit;
end

%!test
%! % results come in standard units, of the targets that are kept
%! gapProblem = struct ('kept', [1, 3], 'unit', [2, 5]);
%! data = rmfield (addRows (newData (1, 2, 1), 0.5, [1, 2], 1, 'plan', 0), ...
%!                 'stage');
%! options = struct ('maxNewRuns', 4, 'verifyRuns', 3);
%! state = newGapState (data, gapProblem, options, @(X, E, r) [X, E, X + E]);
%! assert ({state.left, state.repeats, state.data.stage}, {4, 3, {'import'}});
%! Z = state.evaluate (2, 8, 1, 'gap', state.budget);
%! assert (Z, [1, 2]);
%! % nothing may be run
%! state = newGapState (data, gapProblem, options, []);
%! assert (isempty (state.evaluate));
