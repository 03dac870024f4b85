% BOOKSTEP  Appends the present set to the history of a calibration.
%
% CALL: STATE = bookStep (STATE, PROBLEM, STAGE, ITERATION [, SAY])
%
%   STAGE  'infill' or 'DEM'; ITERATION  integer; SAY  gets a line about the step
%   STATE  its history: residual T x 1 is what all runs together let expect at the
%          set, ofRuns T x 1 that of the mean of the DEM runs there (NaN: no run)

function state = bookStep (state, problem, stage, iteration, say)
  found = state.found;
  residual = found.residual(1:numel (state.surrogates));
  final = confirmSet (state, problem);
  ofRuns = final.residual;
  if final.n == 0
    ofRuns(:) = NaN;
  end
  runs = sum (isAfterPlan (state.data));
  state.history(end + 1) = struct ('stage', stage, 'iteration', iteration, ...
                                   'params', found.params, 'residual', residual, ...
                                   'ofRuns', ofRuns, 'runs', runs, ...
                                   'probability', found.probability);
  if nargin > 4
    names = {state.surrogates.name};
    tol = problem.tol;
    tol(problem.scale == problem.value) = NaN;
    values = struct ('stage', stage, 'n', iteration, 'runs', runs, ...
                     'here', final.n, 'mean', residualText (ofRuns, names, tol), ...
                     'expected', residualText (residual, names, tol), ...
                     'chance', sprintf ('%.2f', found.probability));
    say (['  ', sentence(merge(final.n > 0, 'step.runs', 'step.surrogates'), values)]);
  end
end

%!test
%! % what is said of DEM runs is of them; the surrogates are said to be others
%! [problem, state] = smallCalibration ();
%! state.found.residual = [0.01; -0.02];
%! state.found.probability = 0.5;
%! said = evalc ('state = bookStep (state, problem, ''infill'', 2, @disp);');
%! assert (isempty (strfind (said, 'these values')));
%! assert (! isempty (strfind (said, 'expected from all runs y -2, x 1')), said);
%! assert (state.history.iteration, 2);
%! assert (all (isnan (state.history.ofRuns)));
%! state.data = addRows (state.data, [0.5, 1; 0.5, 1], [4.4, 2; 4.2, 2], [1; 2], 'verify');
%! said = evalc ('state = bookStep (state, problem, ''DEM'', 3, @disp);');
%! assert (! isempty (strfind (said, '2 runs with these values x 7.5, y 0')), said);
%! assert (state.history(2).ofRuns, [0.075; 0], 1e-12);
%! assert (state.history(2).residual, [0.01; -0.02]);

% SPDX-License-Identifier: GPL-3.0-only
