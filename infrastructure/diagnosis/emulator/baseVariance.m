% BASEVARIANCE  How well the model without effects is known at some parameters.
%
% CALL: V = baseVariance (EMULATOR, THETA)
%
%   EMULATOR  struct of fitEmulator
%   THETA     n x p, parameters in [-1, 1]
%   V         n x T, variance of the mean response: of the Kriging models, and of
%             the polynomial that stands for them

function v = baseVariance (emulator, theta)
  X = fromSymmetric (theta, emulator.limits);
  [~, v] = predictSurrogate (emulator.surrogates, X);
  v = v + emulator.fitVar;
end

%!test
%! X = (0:0.25:1)';
%! s = fitSurrogate (X, 1 + X, [0; 1], struct ('trend', 'affine', ...
%!                   'covariance', 'matern52'));
%! emulator = struct ('limits', [0; 1], 'surrogates', s, 'fitVar', 3);
%! [~, v] = predictSurrogate (s, [0.5; 1]);
%! assert (baseVariance (emulator, [0; 1]), v + 3);

% SPDX-License-Identifier: GPL-3.0-only
