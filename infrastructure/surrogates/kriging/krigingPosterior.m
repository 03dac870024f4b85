% KRIGINGPOSTERIOR  Posterior of the standardised response at some sets.
%
% CALL: [M, V, S] = krigingPosterior (SURROGATE, P)
%
% P          n x d, parameter sets; of a surrogate with a further input
%            n x (d + 1) where that is not 0
% M, V       n x 1, mean and variance, without the noise of a run and without
%            the surrogate's factor
% S          n x n, covariance, V its diagonal

function [m, v, S] = krigingPosterior (surrogate, P)
  s = surrogate.solver;
  model = surrogate.model;
  U = unitInputs (P, surrogate.limits, columns (surrogate.extra));
  isOpen = nargout > 1 && ~isempty (s.open);
  if isOpen
    [k, D] = covarianceOf (surrogate, U, s.unit);
  else
    k = covarianceOf (surrogate, U, s.unit);
  end
  h = feval (model.lm, U);
  m = h * s.beta + k * s.alpha;
  if nargout > 1
    % what the runs tell, and what the trend and the parameters leave open
    B = s.L \ k';
    C = s.R' \ (h' - s.A' * B);
    if isOpen
      C = [C; (h * s.open.beta + k * s.open.alpha + ...
               D * s.open.root(1:columns (D), :))'];
    end
    v = exp (model.param(1)) - sum (B.^2, 1)' + sum (C.^2, 1)';
  end
  if nargout > 2
    S = covarianceOf (surrogate, U, U) - B' * B + C' * C;
  end
end

%!test
%! % at a run without noise the mean is the run, and nothing is open
%! X = [0; 0.4; 0.7; 1];
%! s = fitSurrogate (X, sin (3 * X), [0; 1], ...
%!                   struct ('noise', 1e-12 * ones (4, 1)));
%! [m, ~, S] = krigingPosterior (s, 0.4);
%! assert (s.shift + s.scale * m, sin (1.2), 1e-5);
%! assert (S, 0, 1e-6);
%! [~, v, S] = krigingPosterior (s, [0.1; 0.35; 0.8]);
%! assert (diag (S), v, 1e-9);
