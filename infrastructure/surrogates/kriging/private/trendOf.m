% TRENDOF  The trend of a Kriging model, as stk calls it.
%
% CALL: LM = trendOf (TREND)
%
%   TREND  'constant', 'affine', 'quadratic': stk_lm_TREND; or d x 2, slope and
%          curvature of a known shape along each of the first d inputs: a level, the
%          shape times a factor, and slopes along inputs where TREND is NaN
%   LM     what stands in a model of stk: feval (LM, U), n x d -> n x terms

function lm = trendOf (trend)
  if ischar (trend)
    lm = feval (['stk_lm_', trend]);
  else
    lm = @(U) shapeTerms (double (U), trend);
  end
end

function H = shapeTerms (U, shape)
  d = rows (shape);
  isKnown = isfinite (shape(:, 1));
  known = U(:, isKnown);
  H = [ones(rows (U), 1), known * shape(isKnown, 1) + known.^2 * shape(isKnown, 2), ...
       U(:, ~isKnown), U(:, d + 1:end)];
end

%!test
%! pkg load stk
%! U = [0.5, 1, 0.2; 1, 0, 0.3];
%! assert (feval (trendOf ('affine'), U), [[1; 1], U]);
%! assert (feval (trendOf ([2, -1; 3, 1; NaN, NaN]), U), [1, 4.75, 0.2; 1, 1, 0.3]);
%! assert (feval (trendOf ([2, -1; 3, 1]), U), [1, 4.75, 0.2; 1, 1, 0.3]);

% SPDX-License-Identifier: GPL-3.0-only
