% RUNFORINTERVALS  Makes the runs that intervals of parameters need on a curve.
%
% CALL: STATE = runForIntervals (STATE, PROBLEM)
%
% Infill leaves its runs around one set. What surrogates get wrong between runs
% is smooth along a curve, as a change of the parameters is, and intervals come
% out too narrow (closed study curveFewRuns.m). So, where options.intervals asks
% for it, options.intervalRuns sets are run at draws of the posterior, each as
% far as can be from all sets that were run.

function state = runForIntervals (state, problem)
  if ~problem.options.intervals || budgetLeft (state, problem) < 1
    return
  end
  sample = parameterPosterior (state.surrogates, problem).sample;
  far = farPoints (toUnit (sample, problem.limits), ...
                   toUnit (state.data.X, problem.limits), ...
                   problem.options.intervalRuns);
  state = runAndFit (state, problem, sample(far, :), 'interval');
  state = moveTo (state, problem);
end

%!test
%! % none where the case does not ask; else in the posterior, and apart
%! [problem, state] = smallCalibration ();
%! assert (isequal (runForIntervals (state, problem), state));
%! problem.options.intervals = true;
%! problem.options.intervalRuns = 3;
%! known = parameterPosterior (state.surrogates, problem);
%! out = runForIntervals (state, problem);
%! new = out.data.X(strcmp (out.data.stage, 'interval'), :);
%! assert (rows (new), 3);
%! assert (ismember (new, toDigits (known.sample), 'rows'));
%! assert (rows (unique (new, 'rows')), 3);

% SPDX-License-Identifier: GPL-3.0-only
