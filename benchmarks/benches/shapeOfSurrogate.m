% SHAPEOFSURROGATE  How a result follows the parameters, as its surrogate has it.
%
% CALL: C = shapeOfSurrogate (S, LIMITS)
%
%   S       surrogate of one result (fitSurrogate); inputs beyond the parameters are 0
%   LIMITS  2 x d, lower limits above upper ones
%   C       d x 2, slope and curvature along each parameter, x = (p - lower) / (upper -
%           lower), in the unit of the result: the parabolas whose sum is nearest to the
%           mean response in the box
%
% See also: knownShapes

function C = shapeOfSurrogate (s, limits)
  [n, d] = deal (400, columns (limits));
  U = sampleBox (n, [0; 1] .* ones (1, d));
  P = limits(1, :) + U .* diff (limits(1:2, :));
  m = predictSurrogate (s, [P, zeros(n, columns (s.X) - d)]);
  b = [ones(n, 1), U, U.^2] \ m;
  C = reshape (b(2:end), d, 2);
end

%!test
%! rand ('twister', 1);
%! X = rand (30, 2) .* [2, 1];
%! s = fitSurrogate (X, 3 + X(:, 1) - X(:, 2).^2, [0, 0; 2, 1]);
%! assert (shapeOfSurrogate (s, [0, 0; 2, 1]), [2, 0; 0, -1], 0.2);

% SPDX-License-Identifier: GPL-3.0-only
