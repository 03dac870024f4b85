% STUDYGAP  What a diagnosis rests on, before it judges: runs, emulator, evidence.
%
% CALL: STUDY = studyGap (GIVEN, DATA, OPTIONS, EVALUATE [, LEVELS])
%
%   GIVEN, DATA, OPTIONS, EVALUATE  see diagnoseMatrices
%   LEVELS  1 x m, chances of a false alarm at one of which it will be judged
%           (OPTIONS.significance)
%   STUDY   that of makeStudy, of the effects that can be tested, and
%     p          of the gate
%     untested   names of the effects without a finished run
%     data       DATA with the new runs
%     state, known   of exploreGap
%
% See also: diagnoseMatrices, stepDown

function study = studyGap (given, data, options, evaluate, levels)
  options = gapOptions (options);
  if nargin < 5
    levels = options.significance;
  end
  data = checkMatrices (given, data, evaluate);
  explored = exploreGap (given, data, options, evaluate);
  [problem, emulator] = setAside (explored.problem, explored.emulator, options);
  effects = emulator.effect;
  isTested = [effects.laboratory] | [effects.runs] >= 1;
  study = makeStudy (problem, withoutEffects (emulator, find (~isTested)), options, levels);
  study.p = gapTest (study.hypotheses, study.fits.logE(1, :)).p;
  study.untested = {effects(~isTested).name};
  study.data = explored.data;
  [study.state, study.known] = deal (explored.state, explored.known);
end

%!test
%! % p is there before any verdict, and the verdict's own
%! [given, data, means] = smallGapLab ();
%! given.value = means ([0.4, 0.6], [0, 0, 0.6, 0, 0]);
%! quick = struct ('bootstrap', 49, 'twins', 60, 'trend', 'affine');
%! study = studyGap (given, data, quick, []);
%! assert (study.p < 0.05);
%! assert (study.untested, {});
%! assert (diagnoseMatrices (study).which.gateP, study.p);
%! % what would be an alarm is none at a stricter level
%! study.hypotheses.options.significance = study.p / 2;
%! assert (diagnoseMatrices (study).which.verdict, 'no gap');

% SPDX-License-Identifier: GPL-3.0-only
