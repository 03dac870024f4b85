% POSTERIORCOVARIANCE  How the responses at some sets vary together.
%
% CALL: [S, M] = posteriorCovariance (SURROGATE, P)
%
%   SURROGATE  scalar struct of fitSurrogate
%   P          n x d or n x (d + 1), parameter sets (see krigingTerms)
%   S          n x n, posterior covariance of the standardised response, without
%              the noise of a run and without the surrogate's factor
%   M          n x 1, its posterior mean

function [S, m] = posteriorCovariance (surrogate, P)
  [m, B, C, U] = krigingTerms (surrogate, P);
  S = covarianceOf (surrogate, U, U) - B' * B + C' * C;
end

%!test
%! % its diagonal is the variance of the prediction
%! pkg load stk
%! X = [0; 0.2; 0.5; 0.6; 1];
%! s = fitSurrogate (X, [1; 3; 2; 2.5; 0], [0; 1]);
%! P = [0.1; 0.35; 0.8];
%! [S, m] = posteriorCovariance (s, P);
%! [known, v] = predictSurrogate (s, P);
%! assert (s.shift + s.scale * m, known, 1e-12);
%! assert (s.factor * s.scale^2 * diag (S), v, 1e-9);
