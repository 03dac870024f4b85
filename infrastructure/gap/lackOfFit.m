% LACKOFFIT  Tests a fitted hypothesis by simulated data that are fitted again.
%
% CALL: TEST = lackOfFit (WHITE, H, Q, CHI2, OPTIONS)
%
%   WHITE    struct of whitenEmulator
%   H        1 x h, numbers of the active effects
%   Q        1 x (p + h), fitted point;  CHI2 its misfit
%   OPTIONS  struct: prior (as in makeModels), repeats (scalar), seed (scalar)
%   TEST     struct p (scalar), chi2 (repeats x 1), residual (repeats x T, after
%            the new fit, whitened)
%
% p = (1 + number of refits with a larger misfit) / (repeats + 1). Refitting
% takes the freedom of the parameters into account without counting them.
%
% See also: fitHypothesis, locateGap

function test = lackOfFit (white, h, Q, chi2, options)
  T = columns (white.coef);
  noise = integrationPoints (options.repeats, T, options.seed).normal;
  [M, V] = predictGap (white, h, Q);
  Z = M + sqrt (V) .* noise;
  box = hypothesisBox (white, h, options.prior);
  fit = fitHypothesis (white, h, Z, repmat (Q, options.repeats, 1), box);
  test.chi2 = fit.chi2;
  test.p = (1 + sum (fit.chi2 >= chi2 - fitTolerance ())) / ...
           (options.repeats + 1);
  test.residual = Z - predictGap (white, h, fit.Q);
end

%!test
%! % a straight line through 12 points: chi2 with 11 degrees of freedom
%! white = struct ('p', 1, 'powers', [0; 1], 'coef', [0; 1] * (1:12), ...
%!                 'varPowers', 0, 'varCoef', zeros (1, 12), 'effect', []);
%! prior = struct ('mean', 0, 'precision', 0, 'widen', 1);
%! options = struct ('prior', prior, 'repeats', 999, 'seed', 1);
%! test = lackOfFit (white, [], 0, 19.675, options);
%! assert (test.p, 0.05, 0.03);
%! assert (mean (test.chi2), 11, 0.6);
