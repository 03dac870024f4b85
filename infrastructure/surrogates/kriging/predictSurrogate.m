% PREDICTSURROGATE  Mean and variance of the responses from their surrogates.
%
% CALL: [M, V] = predictSurrogate (SURROGATES, P)
%
% P           n x d  parameter sets; beside them extra, see krigingPosterior
% M, V        n x T  mean of the response and its variance (the noise of a run
%             is not in it: add surrogates(t).noiseVar to predict a run)
%
% stk_predict, and what the surrogate adds to it. A call costs 1 ms more than each
% set in it: predict many sets at once.
%
% Errors: DEcalioc:predictSurrogate:badShape

function [m, v] = predictSurrogate (surrogates, P)
  if ~isempty (surrogates) && ~any (columns (P) == widths (surrogates))
    error ('DEcalioc:predictSurrogate:badShape', ...
           'predictSurrogate: P must be n x %d, got %d x %d.', ...
           size (surrogates(1).limits, 2), size (P));
  end
  n = rows (P);
  T = numel (surrogates);
  [m, v] = deal (zeros (n, T));
  chunk = 2000;
  for first = 1:chunk:n
    part = first:min (n, first + chunk - 1);
    for t = 1:T
      if nargout > 1
        [m(part, t), v(part, t)] = predictOne (surrogates(t), P(part, :));
      else
        m(part, t) = predictOne (surrogates(t), P(part, :));
      end
    end
  end
end

function n = widths (surrogates)
  d = columns (surrogates(1).limits);
  n = d:d + any (~cellfun (@isempty, {surrogates.extra}));
end

function [m, v] = predictOne (surrogate, P)
  if nargout > 1
    [m, v] = krigingPosterior (surrogate, P);
    v = surrogate.factor * surrogate.scale^2 * max (v, 0);
  else
    m = krigingPosterior (surrogate, P);
  end
  m = surrogate.shift + surrogate.scale * m;
end

%!test
%! % an affine response without noise is met everywhere
%! rand ('twister', 1);
%! X = rand (12, 3);
%! s = fitSurrogate (X, X * [1; 2; 3], [0, 0, 0; 1, 1, 1]);
%! P = rand (5, 3);
%! [m, v] = predictSurrogate ([s, s], P);
%! assert (m, repmat (P * [1; 2; 3], 1, 2), 1e-2);
%! assert (size (v), [5, 2]);
%! assert (all (v(:) >= 0));

%!error id=DEcalioc:predictSurrogate:badShape
%! predictSurrogate (struct ('limits', [0; 1], 'extra', []), [1, 2]);

% SPDX-License-Identifier: GPL-3.0-only
