% CHISQUARETAIL  Gives the upper tail of the chi-square distribution.
%
% CALL: P = chiSquareTail (X, NU)
%
%   X    any shape, values (negative ones count as 0)
%   NU   same shape or scalar, degrees of freedom (> 0)
%   P    probability of a value above X

function p = chiSquareTail (x, nu)
  p = gammainc (max (x, 0) / 2, nu / 2 + zeros (size (x)), 'upper');
end

%!assert (chiSquareTail (2 * log (20), 2), 0.05, 10 * eps)
%!assert (chiSquareTail ([0, -1], 5), [1, 1])
