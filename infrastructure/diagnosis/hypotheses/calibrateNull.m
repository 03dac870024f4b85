% CALIBRATENULL  Calibrates the model without effects by its surrogates.
%
% CALL: THETA = calibrateNull (PROBLEM, EMULATOR, OPTIONS)
%
%   PROBLEM, EMULATOR, OPTIONS     of newProblem, fitEmulator, gapOptions
%   THETA                    1 x p, parameters in [-1, 1]

function theta = calibrateNull (problem, emulator, options)
  hypotheses = makeHypotheses (problem, withoutEffects (emulator), options);
  % no effect and no discrepancy: what a calibration would find
  hypotheses.list = hypotheses.list(1);
  fits = fitLibrary (hypotheses, problem.value(problem.used));
  theta = fits.calibrated.Q;
end

%!test
%! % what the laboratory was run with is found (noise 0.2, slopes of 3)
%! [given, data, means] = smallGapLab ();
%! given.value = means ([0.4, 0.7], zeros (1, 5));
%! study = labStudy (given, data);
%! theta = calibrateNull (study.problem, study.emulator, study.hypotheses.options);
%! assert (theta, [-0.2, 0.4], 0.1);

% SPDX-License-Identifier: GPL-3.0-only
