% FITTOLERANCE  Misfit that a fit may leave because it ends early.
%
% CALL: CHI2 = fitTolerance ()
%
% fitHypothesis ends where the log posterior density rises by less than
% 0.002. Where parameters can meet all targets the misfit is 0 but for this, and
% means nothing.
%
% See also: fitHypothesis, lackOfFit, locateGap

function chi2 = fitTolerance ()
  chi2 = 0.02;
end
