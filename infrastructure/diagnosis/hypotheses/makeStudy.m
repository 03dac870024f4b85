% MAKESTUDY  Hypotheses, their fits, and what the gate compares with.
%
% CALL: STUDY = makeStudy (PROBLEM, EMULATOR, OPTIONS [, LEVELS])
%
%   PROBLEM, EMULATOR, OPTIONS  of newProblem, emulate, gapOptions
%   LEVELS  see gapReference (OPTIONS.significance)
%   STUDY   struct problem, emulator, hypotheses (makeHypotheses, gapReference), fits
%           (fitLibrary, of the measured values)

function study = makeStudy (problem, emulator, options, levels)
  if nargin < 4
    levels = options.significance;
  end
  hypotheses = makeHypotheses (problem, emulator, options);
  fits = fitLibrary (hypotheses, problem.value(problem.used));
  hypotheses = gapReference (hypotheses, ...
                             gapTest (hypotheses, fits.logE).statistic, levels);
  hypotheses.alone = readingsAlone (problem, emulator, fits.calibrated.Q(1, :));
  study = struct ('problem', problem, 'emulator', emulator, 'hypotheses', hypotheses, ...
                  'fits', fits);
end

%!test
%! [given, data, means] = smallGapLab ();
%! given.value = means ([0.4, 0.6], zeros (1, 5));
%! options = gapOptions (struct ('trend', 'affine', 'twins', 60));
%! problem = newProblem (given);
%! study = makeStudy (problem, emulate (problem, data, options), options);
%! assert (gapTest (study.hypotheses, study.fits.logE).p > 0.05);

% SPDX-License-Identifier: GPL-3.0-only
