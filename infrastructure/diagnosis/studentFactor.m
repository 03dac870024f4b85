% STUDENTFACTOR  Standard uncertainty over the scale of Student's distribution.
%
% CALL: F = studentFactor (FREEDOM)
%
%   FREEDOM  array, degrees of freedom (Inf: normal)
%   F        of the same shape: within F times the scale lie 68 % (GUM 6.2.2), as
%            within one standard deviation of a normal error

function f = studentFactor (freedom)
  f = -studentQuantile (0.1587, freedom);
  f(isinf (freedom)) = 1;
end

%!assert (studentFactor ([2, Inf; 1, 1e7]), [1.32, 1; 1.84, 1], 5e-3)

% SPDX-License-Identifier: GPL-3.0-only
