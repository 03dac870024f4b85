% SOLVEMANY  Solves many small positive definite systems at once.
%
% CALL: X = solveMany (A, G)
%
%   A   n x d x d, one symmetric positive definite matrix a row
%   G   n x d, right-hand sides
%   X   n x d, the i-th row solves A(i,:,:) * X(i,:)' = G(i,:)'
%
% Gaussian elimination without pivoting, vectorised over the systems.
%
% See also: fitHypothesis

function X = solveMany (A, G)
  d = columns (G);
  for k = 1:d
    for i = k + 1:d
      factor = A(:, i, k) ./ A(:, k, k);
      A(:, i, k:d) = A(:, i, k:d) - factor .* A(:, k, k:d);
      G(:, i) = G(:, i) - factor .* G(:, k);
    end
  end
  X = zeros (size (G));
  for k = d:-1:1
    left = G(:, k);
    for j = k + 1:d
      left = left - A(:, k, j) .* X(:, j);
    end
    X(:, k) = left ./ A(:, k, k);
  end
end

%!test
%! B = [4, 1, 0; 1, 3, 1; 0, 1, 2];
%! A = permute (cat (3, B, 2 * B), [3, 1, 2]);
%! X = solveMany (A, [1, 2, 3; 1, 2, 3]);
%! assert (X, [(B \ [1; 2; 3])'; (B \ [1; 2; 3])' / 2], 1e-14);
