% LABSTUDY  What a diagnosis holds once its surrogates are fitted, for tests.
%
% CALL: STUDY = labStudy (GIVEN, DATA, OPTIONS)
%
%   GIVEN    struct for newProblem;  DATA  struct X, E, Z, replicate
%   OPTIONS  struct of gapOptions (default: trend 'affine')
%   STUDY    struct gapProblem, em, models, fits
%
% See also: standInGap, smallGapLab, diagnoseMatrices

function study = labStudy (given, data, options)
  if nargin < 3
    options = struct ();
  end
  options = gapOptions (mergeFields (struct ('trend', 'affine'), options));
  study.gapProblem = newProblem (given);
  study.em = fitEmulator (study.gapProblem, data, options);
  study.models = makeHypotheses (study.gapProblem, study.em, options);
  used = study.gapProblem.used;
  study.fits = fitLibrary (study.models, study.gapProblem.value(used));
end

%!test
%! [given, data] = smallGapLab ();
%! given.value = mean (data.Z);
%! study = labStudy (given, data);
%! assert (numel (study.models.names), 5);
%! assert (rows (study.fits.Z), 1);
