% KRIGINGPOSTERIOR  Posterior of the standardised response at some sets.
%
% CALL: [M, V, S, NOISE] = krigingPosterior (SURROGATE, P)
%
% P          n x d, parameter sets; of a surrogate with a further input
%            n x (d + 1) where that is not 0
% M, V       n x 1, mean and variance, without the noise of a run and without
%            the surrogate's factor
% S          n x n, covariance, V its diagonal
% NOISE      n x 1, variance of a run there (noiseAt)

function [m, v, S, noise] = krigingPosterior (surrogate, P)
  s = surrogate.solver;
  U = unitInputs (P, surrogate.limits, columns (surrogate.extra));
  isOpen = nargout > 1 && ~isempty (s.open);
  % a variance of -1e-15 is none; without a prior the noise may vanish
  for id = {'STK:stk_predict:NegativeVariancesSetToZero', ...
            'Octave:nearly-singular-matrix', 'Octave:singular-matrix'}
    warning ('off', id{1}, 'local');
  end
  if nargout > 2
    [z, weights, ~, S] = stk_predict (s.posterior, U);
  elseif isOpen
    [z, weights] = stk_predict (s.posterior, U);
  else
    z = stk_predict (s.posterior, U);
  end
  z = double (z);
  m = z(:, 1);
  v = z(:, 2);
  if isOpen
    % what the parameters leave open, see parameterSpread
    root = s.open.root;
    C = covarianceSlopes (surrogate, U) * root(1:numel (surrogate.model.param), :) - ...
        weights' * s.open.runs;
    v = v + sumsq (C, 2);
    if nargout > 2
      S = S + C * C';
    end
  end
  if nargout > 3
    extra = zeros (rows (P), 1);
    if columns (P) > columns (surrogate.limits)
      extra = P(:, end);
    end
    noise = noiseAt (surrogate, extra) / surrogate.scale^2;
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

% SPDX-License-Identifier: GPL-3.0-only
