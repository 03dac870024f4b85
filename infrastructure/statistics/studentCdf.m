% STUDENTCDF  Student's distribution function.
%
% CALL: P = studentCdf (X, DF)
%
% X   matrix; DF  scalar, degrees of freedom (Inf: normal); P  size of x
%
% p = 1 - I(df / (df + x^2); df/2, 1/2) / 2 for x >= 0 (incomplete beta)

function p = studentCdf (x, df)
  if df > 1e5
    p = 0.5 * erfc (-x / sqrt (2));
    return
  end
  tail = 0.5 * betainc (df ./ (df + x.^2), df / 2, 0.5);
  p = tail;
  p(x > 0) = 1 - tail(x > 0);
end

%!assert (studentCdf ([0, 2.015048, -2.015048], 5), [0.5, 0.95, 0.05], 1e-6)
%!assert (studentCdf (1.644854, Inf), 0.95, 1e-6)
%!assert (studentCdf (1, 1), 0.75, 1e-12)
