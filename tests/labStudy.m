% LABSTUDY  What a diagnosis holds once its surrogates are fitted, for tests.
%
% CALL: STUDY = labStudy (GIVEN, DATA, OPTIONS)
%
%   GIVEN    struct for newProblem;  DATA  struct X, E, Z, replicate
%   OPTIONS  struct of gapOptions (default: trend 'affine')
%   STUDY    struct problem, emulator, hypotheses, fits
%
% See also: standInGap, smallGapLab, diagnoseMatrices

function study = labStudy (given, data, options)
  if nargin < 3
    options = struct ();
  end
  options = gapOptions (mergeFields (struct ('trend', 'affine'), options));
  study.problem = newProblem (given);
  study.emulator = fitEmulator (study.problem, data, options);
  study.hypotheses = makeHypotheses (study.problem, study.emulator, options);
  used = study.problem.used;
  study.fits = fitLibrary (study.hypotheses, study.problem.value(used));
end

%!test
%! [given, data] = smallGapLab ();
%! given.value = mean (data.Z);
%! study = labStudy (given, data);
%! assert (numel (study.hypotheses.names), 5);
%! assert (rows (study.fits.Z), 1);

% SPDX-License-Identifier: GPL-3.0-only
