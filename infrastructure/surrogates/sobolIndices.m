% SOBOLINDICES  Global sensitivity of each response, on the surrogates.
%
% CALL: S = sobolIndices (SURROGATES, PROBLEM)
% CALL: S = sobolIndices (SURROGATES, PROBLEM, N)
%
% SURROGATES  1 x T struct array of fitSurrogates
% PROBLEM     struct of newProblem (limits and names are used)
% N           base sample (1024); N (d + 2) predictions are made
% S           struct: first, total d x T (shares of the variance of the
%             response over the box), names, targets
%
% Estimators of Saltelli et al. 2010 (first order) and Jansen 1999 (total);
% their error is about 1 / sqrt (N). A constant response gives zeros.

function S = sobolIndices (surrogates, problem, N)
  if nargin < 3
    N = 1024;
  end
  d = columns (problem.limits);
  unit = double (stk_sampling_halton_rr2 (N, 2 * d, ...
                                          [zeros(1, 2 * d); ...
                                           ones(1, 2 * d)]));
  lo = problem.limits(1, :);
  width = diff (problem.limits);
  A = lo + unit(:, 1:d) .* width;
  B = lo + unit(:, d + 1:end) .* width;
  fA = predictSurrogate (surrogates, A);
  fB = predictSurrogate (surrogates, B);
  centre = mean ([fA; fB], 1);
  fA = fA - centre;
  fB = fB - centre;
  variance = mean ([fA; fB].^2, 1);
  variance(variance < 1e-20 * centre.^2) = Inf;
  S.first = zeros (d, numel (surrogates));
  S.total = S.first;
  for j = 1:d
    C = A;
    C(:, j) = B(:, j);
    fC = predictSurrogate (surrogates, C) - centre;
    S.first(j, :) = mean (fB .* (fC - fA), 1) ./ variance;
    S.total(j, :) = 0.5 * mean ((fA - fC).^2, 1) ./ variance;
  end
  S.first = max (S.first, 0);
  S.names = problem.names;
  S.targets = {surrogates.name};
end

%!test
%! % y = a + 2 b: shares 1/5, 4/5, no interaction; c has none
%! pkg load stk
%! rand ('twister', 1);
%! X = rand (20, 3);
%! s = fitSurrogate (X, X * [1; 2; 0], [0, 0, 0; 1, 1, 1]);
%! problem = struct ('limits', [0, 0, 0; 1, 1, 1], ...
%!                   'names', {{'a', 'b', 'c'}});
%! S = sobolIndices (s, problem);
%! assert (S.first, [0.2; 0.8; 0], 0.06);
%! assert (S.total, [0.2; 0.8; 0], 0.06);
