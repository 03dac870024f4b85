% BENCHDENSITY  Log density of what the targets of a bench are off by.
%
% CALL: FIT = benchDensity (R, TOTAL, LEVEL, LIKENESS)
%
%   R         n x a, measured values less those of the surrogates
%   TOTAL     n x a, variances of these
%   LEVEL     n x c, normal scores of the levels of the curves of this bench
%   LIKENESS  one of benchLikeness
%   FIT       n x 1, without that of each curve by itself
%
% Of the levels a normal copula; of single targets multivariate Student, given
% these. Of a covariance that was estimated with df
% degrees of freedom df - a + 1 are left, and the scatter is wider by the root of
% their ratio, as that of a prediction whose covariance is unknown (Anderson 2003,
% 5.2); of one target this is Student's distribution with df.

function fit = benchDensity (r, total, level, likeness)
  [a, nu] = deal (columns (r), likeness.freedom);
  total = total .* likeness.wider;
  z = r ./ sqrt (total);
  C = likeness.correlation;
  ofLevels = chol (C(a + 1:end, a + 1:end));
  fit = -sum (log (diag (ofLevels))) - 0.5 * (sumsq (level / ofLevels, 2) - sumsq (level, 2));
  if a > 0
    link = C(a + 1:end, a + 1:end) \ C(a + 1:end, 1:a);
    root = chol (C(1:a, 1:a) - C(1:a, a + 1:end) * link);
    fit = fit - 0.5 * sum (log (total), 2) - sum (log (diag (root))) - ...
          (nu + a) / 2 * log1p (sumsq ((z - level * link) / root, 2) / nu);
  end
end

%!test
%! % of one target Student's distribution; of many degrees of freedom the normal one
%! % of both together, or of one given the other
%! one = struct ('correlation', 1, 'freedom', 5, 'wider', 1);
%! assert (benchDensity (3, 4, zeros (1, 0), one), ...
%!         -0.5 * log (4) - 3 * log1p (9 / 4 / 5), 1e-12);
%! C = [1, 0.6; 0.6, 1];
%! x = [0.3, -1];
%! two = struct ('correlation', C, 'freedom', 1e9, 'wider', [1, 1]);
%! joint = benchDensity (x, [1, 1], zeros (1, 0), two);
%! assert (joint, -0.5 * x / C * x' - 0.5 * log (det (C)), 1e-6);
%! two.wider = 1;
%! assert (benchDensity (x(1), 1, x(2), two) - 0.5 * x(2)^2, joint, 1e-6);
%! % of two curves alone
%! assert (benchDensity (zeros (1, 0), zeros (1, 0), x, setfield (two, 'wider', [])) - ...
%!         0.5 * sumsq (x), joint, 1e-6);

% SPDX-License-Identifier: GPL-3.0-only
