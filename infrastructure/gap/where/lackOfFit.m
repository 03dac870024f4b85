% LACKOFFIT  Tests a fitted hypothesis by simulated data that are fitted again.
%
% CALL: TEST = lackOfFit (MODELS, FIT, OPTIONS)
%
%   MODELS   struct of makeModels
%   FIT      calibrated null model of fitLibrary, one row
%   OPTIONS  struct: repeats, seed (scalars)
%   TEST     struct p (scalar), chi2 (repeats x 1), residual (repeats x T, after
%            the new fit, whitened)
%
% p = (1 + number of refits with a larger misfit) / (repeats + 1). Refitting
% takes the freedom of the parameters into account without counting them.
%
% See also: fitHypothesis, locateGap

function test = lackOfFit (models, fit, options)
  white = models.white;
  null = newHypothesis ('null');
  noise = integrationPoints (options.repeats, columns (white.coef), ...
                             options.seed).normal;
  [M, V] = predictGap (white, [], fit.Q);
  Z = M + sqrt (V) .* noise;
  flat = setfield (models.prior, 'flat', true);
  again = fitHypothesis (white, null, Z, repmat (fit.U, options.repeats, 1), ...
                         flat);
  test.chi2 = again.chi2;
  margin = models.options.fitMargin;
  test.p = (1 + sum (again.chi2 >= fit.chi2 - margin)) / ...
           (options.repeats + 1);
  test.residual = Z - predictGap (white, [], again.Q);
end

%!test
%! % a straight line through 12 points: chi2 with 11 degrees of freedom
%! models.white = struct ('p', 1, 'powers', [0; 1], 'coef', [0; 1] * (1:12), ...
%!                        'varPowers', 0, 'varCoef', zeros (1, 12), ...
%!                        'nu', Inf (1, 12), 'effect', []);
%! models.prior = struct ('mean', 0, 'sd', Inf);
%! models.options = gapOptions ([]);
%! fit = struct ('Q', 0, 'U', 0, 'chi2', 19.675);
%! test = lackOfFit (models, fit, struct ('repeats', 999, 'seed', 1));
%! assert (test.p, 0.05, 0.03);
%! assert (mean (test.chi2), 11, 0.6);
