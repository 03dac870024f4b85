% PARAMETERPRIOR  What was known of the parameters before.
%
% CALL: PRIOR = parameterPrior (GAPPROBLEM)
%
%   GAPPROBLEM  struct of newGapProblem: limits, paramMean, paramSd are read
%   PRIOR       struct mean, sd (1 x p, parameters in [-1, 1]; sd Inf: uniform)

function prior = parameterPrior (gapProblem)
  half = diff (gapProblem.limits) / 2;
  prior.mean = (gapProblem.paramMean - mean (gapProblem.limits)) ./ half;
  prior.sd = gapProblem.paramSd ./ half;
  without = ~isfinite (prior.mean) | ~isfinite (prior.sd);
  prior.mean(without) = 0;
  prior.sd(without) = Inf;
end

%!test
%! prior = parameterPrior (struct ('limits', [0, 2; 1, 6], 'paramMean', ...
%!                                 [0.75, NaN], 'paramSd', [0.1, NaN]));
%! assert (prior, struct ('mean', [0.5, 0], 'sd', [0.2, Inf]), 1e-12);
