% RECALIBRATE  Calibrates on the refitted surrogates and books the step.
%
% CALL: state = recalibrate (state, problem, stage, iteration)
%
% state      struct of newState; the found set stays where it is unless another
%            one is clearly likelier (by 0.1), so that its runs add up
% stage      'infill' or 'DEM'; iteration  integer
%
% See also: improveByInfill, calibrateOnDEM

function state = recalibrate (state, problem, stage, iteration)
  options = struct ('incumbent', state.found.params, 'nPlan', 1);
  new = calibrateOnKriging (state.surrogates, problem, options);
  here = describeSet (state.surrogates, problem, state.found.params);
  stay = here.probability > new.probability - 0.1 && here.probability > 0.2;
  if stay
    kept = fieldnames (here);
    for i = 1:numel (kept)
      new.(kept{i}) = here.(kept{i});
    end
  end
  state.found = new;
  state = bookStep (state, stage, iteration);
end
