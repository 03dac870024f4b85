% WEIGHTEDQUANTILE  Gives quantiles of weighted samples.
%
% CALL: Q = weightedQuantile (X, WEIGHT, P)
%
%   X        n x 1, samples
%   WEIGHT   n x 1, weights >= 0
%   P        1 x m, probabilities
%   Q        1 x m

function q = weightedQuantile (x, weight, p)
  [x, order] = sort (x(:));
  weight = weight(order);
  share = cumsum (weight(:)) / sum (weight);
  q = zeros (1, numel (p));
  for k = 1:numel (p)
    q(k) = x(find (share >= p(k) - 1e-12, 1));
  end
end

%!assert (weightedQuantile ([3; 1; 2], [1; 1; 2], [0.25, 0.5, 1]), [1, 2, 3])

% SPDX-License-Identifier: GPL-3.0-only
