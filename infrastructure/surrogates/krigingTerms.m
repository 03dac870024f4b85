% KRIGINGTERMS  What a surrogate's posterior at some sets is made of.
%
% CALL: [M, B, C, U] = krigingTerms (SURROGATE, P)
%
% SURROGATE  scalar struct of fitSurrogate
% P          n x d, parameter sets; of a surrogate with levels n x (d + 1) for
%            another level than that which counts (unitLevel)
% M          n x 1, posterior mean of the standardised response
% B, C       its posterior covariance is K - B' B + C' C, with K the prior
%            covariance of the sets: B stands for what the runs tell, C for the
%            trend that they leave open
% U          P in the unit box, with the level where the surrogate has one
%
% The covariance of the runs was factored by conditionSurrogate.

function [m, B, C, U] = krigingTerms (surrogate, P)
  s = surrogate.solver;
  model = surrogate.model;
  d = columns (surrogate.limits);
  U = (P(:, 1:d) - surrogate.limits(1, :)) ./ ...
      (surrogate.limits(2, :) - surrogate.limits(1, :));
  if ~isempty (surrogate.level)
    U(:, d + 1) = 0;
    U(:, d + 1:columns (P)) = P(:, d + 1:end);
  end
  isOpen = nargout > 1 && ~isempty (s.open);
  if isOpen
    [k, D] = covarianceOf (surrogate, U, s.unit);
  else
    k = covarianceOf (surrogate, U, s.unit);
  end
  h = feval (model.lm, U);
  m = h * s.beta + k * s.alpha;
  if nargout > 1
    B = s.L \ k';
    C = s.R' \ (h' - s.A' * B);
    if isOpen
      C = [C; (h * s.open.beta + k * s.open.alpha + ...
               D * s.open.root(1:columns (D), :))'];
    end
  end
end

%!test
%! % at a run without noise the mean is the run, and nothing is open
%! pkg load stk
%! X = [0; 0.4; 0.7; 1];
%! s = fitSurrogate (X, sin (3 * X), [0; 1], ...
%!                   struct ('noise', 1e-12 * ones (4, 1)));
%! [m, B, C, U] = krigingTerms (s, 0.4);
%! assert (s.shift + s.scale * m, sin (1.2), 1e-5);
%! assert (covarianceOf (s, U, U) - B' * B + C' * C, 0, 1e-6);
