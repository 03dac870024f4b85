% SOLVEMANY  Solves many small positive definite systems at once.
%
% CALL: [X, LOGDET] = solveMany (A, G)
%
%   A       n x d x d, one symmetric positive definite matrix a row
%   G       n x d, right-hand sides
%   X       n x d, the i-th row solves A(i,:,:) * X(i,:)' = G(i,:)'
%   LOGDET  n x 1, logarithm of the determinant of each
%
% Gaussian elimination without pivoting, vectorised over the systems.

function [X, logDet] = solveMany (A, G)
  d = columns (G);
  logDet = zeros (rows (G), 1);
  for k = 1:d
    logDet = logDet + log (A(:, k, k));
    below = k + 1:d;
    factor = A(:, below, k) ./ A(:, k, k);
    A(:, below, below) = A(:, below, below) - factor .* A(:, k, below);
    G(:, below) = G(:, below) - factor .* G(:, k);
  end
  X = zeros (size (G));
  for k = d:-1:1
    above = reshape (A(:, k, k + 1:d), rows (G), d - k);
    left = G(:, k) - sum (above .* X(:, k + 1:d), 2);
    X(:, k) = left ./ A(:, k, k);
  end
end

%!test
%! rand ('twister', 1);
%! A = zeros (5, 3, 3);
%! G = rand (5, 3);
%! for i = 1:5
%!   B = rand (3);
%!   A(i, :, :) = B * B' + eye (3);
%! end
%! [X, logDet] = solveMany (A, G);
%! for i = 1:5
%!   assert (squeeze (A(i, :, :)) * X(i, :)', G(i, :)', 1e-12);
%!   assert (logDet(i), log (det (squeeze (A(i, :, :)))), 1e-12);
%! end
