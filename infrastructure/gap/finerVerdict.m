% FINERVERDICT  Whether a verdict would hold at the next finer level.
%
% CALL: LEVEL = finerVerdict (SURROGATES, PROBLEM, GIVEN, OPTIONS, DIAGNOSIS)
%
%   SURROGATES, PROBLEM  see finerStep; PROBLEM may have no levels
%   GIVEN      of gapProblemOf
%   OPTIONS    of gapBudget
%   DIAGNOSIS  of diagnoseMatrices, reached at the last level
%   LEVEL      [] where the case has no levels; else finerStep at the calibrated
%              set, and verdict and effects (of a diagnosis in which the model
%              is moved by the shift and the measurement is less sure by its
%              deviation; '' where the levels tell nothing of the finer one),
%              holds (logical)
%
% How coarse the model is, is a gap of known cause. The runs of all levels say
% how it goes on; no run is made.

function level = finerVerdict (surrogates, problem, given, options, diagnosis)
  level = [];
  % what a finer level does is done to both conditions of a change
  if isempty (problem.coarse) || ~isempty (diagnosis.gapProblem.reference)
    return
  end
  level = finerStep (surrogates, problem, diagnosis.where.params);
  [level.verdict, level.effects, level.holds] = deal ('', {}, false);
  if any (isnan (level.shift))
    return
  end
  given.value = given.value - level.shift;
  given.sd = sqrt (given.sd.^2 + level.shiftSd.^2);
  if ~isempty (given.covariance)
    given.covariance = given.covariance + diag (level.shiftSd.^2);
  end
  % the verdict is wanted, not what else a diagnosis tells
  [options.maxNewRuns, options.trials, options.bootstrap] = deal (0, 0, 1);
  there = diagnoseMatrices (given, diagnosis.data, options, []);
  level.verdict = there.which.verdict;
  level.effects = there.which.effects;
  level.holds = strcmp (level.verdict, diagnosis.which.verdict) && ...
                isequal (level.effects, diagnosis.which.effects);
end

%!test
%! % no levels; a change; levels that tell nothing of a finer one
%! problem.coarse = [];
%! diagnosis.gapProblem.reference = [];
%! diagnosis.where.params = 0.5;
%! verdict = @() finerVerdict (struct ('level', []), problem, struct (), [], ...
%!                             diagnosis);
%! assert (isempty (verdict ()));
%! problem.coarse = struct ('variables', {{'size'}}, 'levels', [4; 2], ...
%!                          'column', 1);
%! level = finerVerdict (struct ('level', []), problem, struct (), [], ...
%!                       diagnosis);
%! assert ({level.shift, level.verdict, level.holds}, {NaN, '', false});
%! diagnosis.gapProblem.reference = 1;
%! assert (isempty (finerVerdict ([], problem, struct (), [], diagnosis)));
