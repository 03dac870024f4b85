% PREDICTSURROGATE  Mean and variance of the responses from their surrogates.
%
% CALL: [m, v] = predictSurrogate (surrogates, P)
%
% surrogates  1 x T struct array of fitSurrogate
% P           n x d  parameter sets
% m, v        n x T  mean of the response and its variance (the noise of a run
%             is not in it: add surrogates(t).noiseVar to predict a run)
%
% Closed form from the factored covariance (equal to stk_predict, which costs
% 0.6 ms more a call). The variance is only computed when it is asked for.
%
% Errors: DEcalioc:predictSurrogate:badShape
%
% See also: fitSurrogate, evaluateKriging

function [m, v] = predictSurrogate (surrogates, P)
  if ~isempty (surrogates) && size (P, 2) ~= size (surrogates(1).limits, 2)
    error ('DEcalioc:predictSurrogate:badShape', ...
           'predictSurrogate: P must be n x %d, got %d x %d.', ...
           size (surrogates(1).limits, 2), size (P));
  end
  n = size (P, 1);
  T = numel (surrogates);
  m = zeros (n, T);
  v = zeros (n, T);
  chunk = 2000;
  for first = 1:chunk:n
    rows = first:min (n, first + chunk - 1);
    for t = 1:T
      if nargout > 1
        [m(rows, t), v(rows, t)] = predictOne (surrogates(t), P(rows, :));
      else
        m(rows, t) = predictOne (surrogates(t), P(rows, :));
      end
    end
  end
end

function [m, v] = predictOne (surrogate, P)
  s = surrogate.solver;
  model = surrogate.model;
  U = (P - surrogate.limits(1, :)) ./ ...
      (surrogate.limits(2, :) - surrogate.limits(1, :));
  w = exp (model.param(2:end))';
  A = U .* w;
  B = s.unit .* w;
  r2 = max (sum (A.^2, 2) + sum (B.^2, 2)' - 2 * A * B', 0);
  k = exp (model.param(1)) * correlationOf (surrogate.covariance, r2);
  h = feval (model.lm, U);
  m = surrogate.shift + surrogate.scale * (h * s.beta + k * s.alpha);
  if nargout > 1
    B = s.L \ k';
    C = s.R' \ (h' - s.A' * B);
    v = exp (model.param(1)) - sum (B.^2, 1)' + sum (C.^2, 1)';
    v = surrogate.factor * surrogate.scale^2 * max (v, 0);
  end
end

%!test
%! % an affine response without noise is met everywhere
%! pkg load stk
%! rand ('twister', 1);
%! X = rand (12, 3);
%! s = fitSurrogate (X, X * [1; 2; 3], [0, 0, 0; 1, 1, 1]);
%! P = rand (5, 3);
%! [m, v] = predictSurrogate ([s, s], P);
%! assert (m, repmat (P * [1; 2; 3], 1, 2), 1e-2);
%! assert (size (v), [5, 2]);
%! assert (all (v(:) >= 0));

%!error id=DEcalioc:predictSurrogate:badShape
%! predictSurrogate (struct ('limits', [0; 1]), [1, 2]);
