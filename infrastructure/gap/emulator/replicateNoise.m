% REPLICATENOISE  Estimates the noise of one run from repeated rows.
%
% CALL: [VARIANCE, DF, RESIDUAL] = replicateNoise (INPUTS, Z)
%
%   INPUTS    n x d, parameters and effects of each run
%   Z         n x T, results, NaN = none
%   VARIANCE  1 x T, pooled over all groups of equal rows (NaN where none)
%   DF        1 x T, degrees of freedom
%   RESIDUAL  n x T, deviation from the mean of the row's group (NaN: alone)
%
% See also: fitEmulator, noiseBudget

function [variance, df, residual] = replicateNoise (inputs, Z)
  [~, ~, group] = unique (inputs, 'rows');
  residual = NaN (size (Z));
  df = zeros (1, columns (Z));
  total = df;
  for g = find (accumarray (group(:), 1)' > 1)
    in = find (group(:)' == g);
    for t = 1:columns (Z)
      ok = in(isfinite (Z(in, t)));
      if numel (ok) > 1
        residual(ok, t) = Z(ok, t) - mean (Z(ok, t));
        total(t) = total(t) + sum (residual(ok, t).^2);
        df(t) = df(t) + numel (ok) - 1;
      end
    end
  end
  variance = total ./ df;
end

%!test
%! Z = [1, 5; 3, NaN; 9, 9; 4, 1; 4, 3];
%! [v, df, r] = replicateNoise ([1; 1; 2; 3; 3], Z);
%! assert (df, [2, 1]);
%! assert (v, [1, 2]);
%! assert (r(3, :), [NaN, NaN]);
%!assert (replicateNoise ([1; 2], [1; 2]), NaN)
