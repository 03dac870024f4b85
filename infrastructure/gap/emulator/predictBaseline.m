% PREDICTBASELINE  Predicts results of the null model by its Kriging models.
%
% CALL: [M, V] = predictBaseline (EM, THETA)
%
%   EM     struct of fitEmulator: surrogates, limits
%   THETA  n x p, parameters in [-1, 1]
%   M, V   n x T, mean and variance of the mean
%
% See also: fitEmulator, predictSurrogate

function [m, v] = predictBaseline (em, theta)
  if is_function_handle (em.surrogates)
    [m, v] = em.surrogates (theta);
    return
  end
  X = em.limits(1, :) + (theta + 1) / 2 .* diff (em.limits);
  [m, v] = predictSurrogate (em.surrogates, X);
end

%!test
%! em.surrogates = @(theta) deal (2 * theta, theta.^2);
%! [m, v] = predictBaseline (em, [1; 3]);
%! assert ([m, v], [2, 1; 6, 9]);
