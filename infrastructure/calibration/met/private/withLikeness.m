% WITHLIKENESS  Log density of targets that are alike, from that of independent ones.
%
% CALL: FIT = withLikeness (FIT, X, LIKENESS)
%
%   FIT       n x 1, log density as if all targets were independent
%   X         n x m, normal scores of the targets that LIKENESS speaks of
%   LIKENESS  one of benchLikeness
%
% The density of a normal copula: each target keeps its own.

function fit = withLikeness (fit, X, likeness)
  root = chol (likeness.correlation);
  fit = fit - sum (log (diag (root))) - 0.5 * (sumsq (X / root, 2) - sumsq (X, 2));
end

%!test
%! % of two normal ones it is the density of both together
%! R = [1, 0.6; 0.6, 1];
%! X = [0.3, -1; 2, 1.5];
%! alone = -0.5 * sumsq (X, 2);
%! both = -0.5 * sum ((X / R) .* X, 2) - 0.5 * log (det (R));
%! assert (withLikeness (alone, X, struct ('correlation', R)), both, 1e-12);
