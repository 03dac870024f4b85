% STUDENTQUANTILE  Quantile of Student's distribution.
%
% CALL: X = studentQuantile (P, DF)
%
% P   scalar in (0, 1); DF  scalar, degrees of freedom (Inf: normal)

function x = studentQuantile (p, df)
  if df > 1e5
    x = sqrt (2) * erfinv (2 * p - 1);
    return
  end
  y = betaincinv (2 * min (p, 1 - p), df / 2, 0.5);
  x = sign (p - 0.5) * sqrt (df * (1 / y - 1));
end

%!assert (studentQuantile (0.95, 5), 2.015048, 1e-6)
%!assert (studentQuantile (0.05, 5), -2.015048, 1e-6)
%!assert (studentQuantile (0.95, Inf), 1.644854, 1e-6)

% SPDX-License-Identifier: GPL-3.0-only
