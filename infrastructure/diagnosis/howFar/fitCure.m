% FITCURE  Fits effects as they are run: set and strengths that DEM is given.
%
% CALL: Q = fitCure (STUDY, MEMBERS)
%
%   STUDY    struct hypotheses, fits
%   MEMBERS  1 x h, numbers of the effects
%   Q        1 x (p + h), parameters in [-1, 1] and strengths that meet the
%            measured values best, with a flat prior of the parameters
%
% By the surrogates as they are: where few runs leave open how large an effect
% is (predictHypothesis), a fit could have a small strength of a larger effect,
% and a run with that strength alone would miss.
%
% See also: runCures, diagnoseMatrices

function Q = fitCure (study, members)
  hypotheses = study.hypotheses;
  % in DEM an effect has the size it has: no amplitude is free
  [hypotheses.white.effect.unbent] = deal (0);
  flat = setfield (hypotheses.prior, 'flat', true);
  fit = fitEffects (hypotheses, study.fits, 1, members, flat);
  Q = fit.Q(1:hypotheses.white.p + numel (members));
end

%!test
%! % one run of each effect, at full strength, and a cause that is as strong: no
%! % smaller strength of a larger effect
%! [given, data, means] = smallGapLab ();
%! given.value = means ([0.4, 0.6], [0, 0, 0.95, 0, 0]);
%! isOne = all (data.E == 0, 2) | any (data.E == 1, 2);
%! study = labStudy (given, keepRows (data, isOne));
%! Q = fitCure (study, 3);
%! assert (Q(3), 0.95, 0.05);
%! white = study.hypotheses.white;
%! z = given.value(study.problem.used) * white.W';
%! [M, V] = predictGap (white, 3, Q);
%! assert (max (abs (z - M) ./ sqrt (V)) < 2);

% SPDX-License-Identifier: GPL-3.0-only
