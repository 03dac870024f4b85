% ALIKEWEIGHTS  Weights of responses whose residuals are alike: fewer in all.
%
% CALL: W = alikeWeights (W, RESIDUAL)
%
%   W         1 x T, weights of the responses
%   RESIDUAL  n x T, a run in each row; NaN: the run lacks the response
%
% All responses together count as sum (w)^2 / sum (w w' R^2) ones; R is the rank
% correlation of the residuals, so that one wrong run does not make it, and R^2
% less what it has by chance.

function w = alikeWeights (w, residual)
  residual = residual(all (isfinite (residual), 2), :);
  if rows (residual) < 4
    return
  end
  chance = 1 / (rows (residual) - 1);
  R2 = (spearman (residual).^2 - chance) / (1 - chance);
  R2(~(R2 > 0)) = 0;
  R2(1:numel (w) + 1:end) = 1;
  w = w * sum (w) / (w * R2 * w');
end

%!test
%! randn ('twister', 2);
%! r = randn (30, 1);
%! assert (alikeWeights ([1, 1], [r, r]), [0.5, 0.5], 1e-9);
%! w = alikeWeights ([1, 1], [r, randn(30, 1)]);
%! assert (sum (w) > 1.6);
%! assert (alikeWeights ([1, 1], [r(1:3), NaN(3, 1)]), [1, 1]);

% SPDX-License-Identifier: GPL-3.0-only
