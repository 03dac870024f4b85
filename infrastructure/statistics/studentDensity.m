% STUDENTDENSITY  Logarithm of the density of a multivariate Student t.
%
% CALL: L = studentDensity (PART, U)
%
%   PART  struct mean (1 x d), root (d x d, lower Cholesky factor of the scale)
%   U     n x d
%   L     n x 1; 7 degrees of freedom, as integrationPoints draws

function L = studentDensity (part, U)
  nu = 7;
  d = columns (U);
  distance = sum (((U - part.mean) / part.root').^2, 2);
  L = gammaln ((nu + d) / 2) - gammaln (nu / 2) - d / 2 * log (nu * pi) - ...
      sum (log (diag (part.root))) - (nu + d) / 2 * log1p (distance / nu);
end

%!test
%! % integrates to 1 in one dimension
%! x = (-60:0.01:60)';
%! L = studentDensity (struct ('mean', 0.5, 'root', 2), x);
%! assert (trapz (x, exp (L)), 1, 1e-4);
%!assert (studentDensity (struct ('mean', [0, 0], 'root', 2 * eye (2)), ...
%!                        [0, 0]), log (1 / (2 * pi) / 4), 1e-12)
