% LEAVEUNJUDGED  Targets that the runs too often lack are not calibrated.
%
% CALL: [STATE, PROBLEM, ISNEW] = leaveUnjudged (STATE, PROBLEM)
%
%   STATE    see newState, with surrogates; its field unjudged is set: cellstr, names
%            of the targets that are set aside
%   PROBLEM  see newProblem; calibrate is false for these
%   ISNEW    logical: there are more of them than before
%
% The runs that have such a result are those in which something flowed. Judged by them
% it would drag the parameters away from what the others ask for. Whether it is
% lacking is seen near the values that these others ask for (where all targets of the
% case are lacking somewhere, in the middle of the runs); once there is a final set,
% that is where (confirmSet).

function [state, problem, isNew] = leaveUnjudged (state, problem)
  isOut = tooOftenLacking (state, problem);
  isNew = any (isOut) && any (problem.calibrate & ~isOut);
  if isNew
    problem.calibrate = problem.calibrate & ~isOut;
    state.unjudged = [state.unjudged, problem.targetNames(isOut)];
  end
end

function isOut = tooOftenLacking (state, problem)
  data = runsThatCount (state.data, problem);
  isOut = problem.calibrate & any (lackingRows (data.Z, problem.bench), 1);
  if strcmp (problem.options.method, 'published')
    isOut(:) = false;
  elseif ~isempty (state.final)
    isOut = isOut & ismember (problem.targetNames, {state.final.unjudged.name});
  elseif any (isOut)
    others = problem;
    others.calibrate = problem.calibrate & ~isOut;
    p = mean (data.X, 1);
    if any (others.calibrate)
      p = calibrateOnKriging (state.surrogates, others).params;
    end
    isOut = isOut & lackingAt (p, state.data, problem) > 0.75;
  end
end

%!test
%! % y is lacking in two of three packings wherever one looks: x is fitted alone
%! problem = smallProblem ([3, 2.5], 0.05);
%! X = linspace (0, 1, 12)';
%! Z = [2 + 2 * X + 0.01 * sin(40 * X), 3 * X + 0.01 * cos(50 * X)];
%! lacks = mod (1:12, 3) > 0;
%! Z(lacks, 2) = NaN;
%! problem.bench = [1, 1];
%! data = addRows (newData (1, 2), X, Z, ones (12, 1), 'plan');
%! state = newState (data, fitSurrogates (data, problem), []);
%! [state, aside] = leaveUnjudged (state, problem);
%! assert ({aside.calibrate, state.unjudged}, {[true, false], problem.targetNames(2)});
%! % far from the values that x asks for it may lack
%! Z(:, 2) = 3 * X + 0.01 * cos (50 * X);
%! Z(X < 0.2, 2) = NaN;
%! state.data.Z = Z;
%! [~, same, isNew] = leaveUnjudged (state, problem);
%! assert ({same.calibrate, isNew}, {[true, true], false});
%! % where the end has shown it
%! state.unjudged = {};
%! state.final = struct ('unjudged', struct ('name', problem.targetNames(2)));
%! [state, aside] = leaveUnjudged (state, problem);
%! assert ({aside.calibrate, state.unjudged}, {[true, false], problem.targetNames(2)});

% SPDX-License-Identifier: GPL-3.0-only
