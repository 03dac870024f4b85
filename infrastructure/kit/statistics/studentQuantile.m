% STUDENTQUANTILE  Quantile of Student's distribution.
%
% CALL: X = studentQuantile (P, DF)
%
% P   scalar in (0, 1); DF  any size, degrees of freedom (Inf: normal); X  as DF

function x = studentQuantile (p, df)
  few = min (df, 1e5);
  y = betaincinv (2 * min (p, 1 - p), few / 2, 0.5);
  x = sign (p - 0.5) * sqrt (few .* (1 ./ y - 1));
  x(df > 1e5) = sqrt (2) * erfinv (2 * p - 1);
end

%!assert (studentQuantile (0.95, 5), 2.015048, 1e-6)
%!assert (studentQuantile (0.05, 5), -2.015048, 1e-6)
%!assert (studentQuantile (0.95, [5, Inf; 5, 5]), [2.015048, 1.644854; 2.015048, 2.015048], 1e-6)

% SPDX-License-Identifier: GPL-3.0-only
