% RECALIBRATE  Calibrates on the refitted surrogates and books the step.
%
% CALL: STATE = recalibrate (STATE, PROBLEM, STAGE, ITERATION)
% CALL: STATE = recalibrate (STATE, PROBLEM, STAGE, ITERATION, MAYMOVE)
%
% STATE      struct of newState; the found set stays where it is once it is
%            sure enough (options.confidence), and unless another one is
%            likelier by 0.02: what the runs at the old one told the surrogates
%            they go on telling; a set whose runs failed twice and never
%            finished is left (failedSets)
% STAGE      'infill' or 'DEM'; ITERATION  integer
% MAYMOVE    logical (true); false: the found set stays in any case
%
% See also: improveByInfill, calibrateOnDEM

function state = recalibrate (state, problem, stage, iteration, mayMove)
  mayMove = nargin < 5 || mayMove;
  problem.avoid = failedSets (state.data, problem);
  here = describeSet (state.surrogates, problem, state.found.params);
  isSure = here.probability >= problem.options.confidence;
  margin = 0.02;
  found = state.found;
  found.conflict = {};
  if mayMove && ~isSure
    options = struct ('incumbent', found.params, 'nPlan', 1);
    found = calibrateOnKriging (state.surrogates, problem, options);
  end
  stay = ~mayMove || isSure || ...
         (here.probability > found.probability - margin && ...
          here.probability > 0.2);
  if stay
    found = mergeFields (found, here);
  end
  state.found = found;
  state = bookStep (state, stage, iteration);
end

%!shared problem, state, s
%! [problem, state, s] = smallCalibration ();

%!test
%! % a sure set stays to the last digit, and the step is booked
%! state.found.params = mostProbableSet (s, problem, zeros (0, 2));
%! out = recalibrate (state, problem, 'DEM', 3);
%! assert (numel (out.history), 1);
%! assert (out.history.iteration, 3);
%! state.data = addRows (state.data, repmat (out.found.params, 2, 1), ...
%!                       NaN (2, columns (state.data.Z)), [1; 2], 'verify');
%! away = recalibrate (state, problem, 'DEM', 4);
%! assert (~isequal (away.found.params, out.found.params));
