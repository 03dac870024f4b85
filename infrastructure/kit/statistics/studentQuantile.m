% STUDENTQUANTILE  Quantile of Student's distribution.
%
% CALL: X = studentQuantile (P, DF)
%
% P   scalar in (0, 1); DF  any size, degrees of freedom (Inf: normal); X  as DF

function x = studentQuantile (p, df)
  x = repmat (sqrt (2) * erfinv (2 * p - 1), size (df));
  few = df <= 1e5;
  if any (few(:))                          % the others need no inverse, which is dear
    y = betaincinv (2 * min (p, 1 - p), df(few) / 2, 0.5);
    x(few) = sign (p - 0.5) * sqrt (df(few) .* (1 ./ y - 1));
  end
end

%!assert (studentQuantile (0.95, 5), 2.015048, 1e-6)
%!assert (studentQuantile (0.05, 5), -2.015048, 1e-6)
%!assert (studentQuantile (0.95, [5, Inf; 5, 5]), [2.015048, 1.644854; 2.015048, 2.015048], 1e-6)

% SPDX-License-Identifier: GPL-3.0-only
