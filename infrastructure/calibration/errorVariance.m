% ERRORVARIANCE  Variance of a measured value about the mean response.
%
% CALL: V = errorVariance (NOISEVAR, PROBLEM, T)
%
% NOISEVAR  variance of one run
% PROBLEM   struct of newProblem
% T         number of the target
% V         scalar: the packing of the trials that were averaged, and the
%           uncertainty of the measurement; where that comes from the scatter of
%           the trials it holds their packings already, and the larger counts
%
% See also: parameterPosterior, noiseBudget

function v = errorVariance (noiseVar, problem, t)
  packing = noiseVar / problem.trials(t);
  if problem.scatter(t)
    v = max (packing, problem.sd(t)^2);
  else
    v = packing + problem.sd(t)^2;
  end
end

%!test
%! problem = struct ('trials', [4, 4, Inf], 'sd', [3, 3, 3], ...
%!                   'scatter', [false, true, false]);
%! assert (errorVariance (16, problem, 1), 13);
%! assert (errorVariance (16, problem, 2), 9);
%! assert (errorVariance (64, problem, 2), 16);
%! assert (errorVariance (16, problem, 3), 9);
