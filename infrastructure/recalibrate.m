% RECALIBRATE  Calibrates on the refitted surrogates and books the step.
%
% CALL: state = recalibrate (state, problem, stage, iteration)
%
% state      struct of newState; the found set stays where it is unless another
%            one is clearly likelier (by 0.1), so that its runs add up; a set
%            whose runs failed twice and never finished is left (failedSets)
% stage      'infill' or 'DEM'; iteration  integer
%
% See also: improveByInfill, calibrateOnDEM

function state = recalibrate (state, problem, stage, iteration)
  problem.avoid = failedSets (state.data);
  here = describeSet (state.surrogates, problem, state.found.params);
  margin = 0.1;
  found = state.found;
  found.conflict = {};
  if here.probability <= 1 - margin
    options = struct ('incumbent', found.params, 'nPlan', 1);
    found = calibrateOnKriging (state.surrogates, problem, options);
  end
  stay = here.probability > 1 - margin || ...
         (here.probability > found.probability - margin && ...
          here.probability > 0.2);
  if stay
    kept = fieldnames (here);
    for i = 1:numel (kept)
      found.(kept{i}) = here.(kept{i});
    end
  end
  state.found = found;
  state = bookStep (state, stage, iteration);
end
