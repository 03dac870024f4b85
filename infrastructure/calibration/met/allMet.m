% ALLMET  Probability that all requirements are truly met.
%
% CALL: P = allMet (R, S, PROBLEM, DF)
%
% R, S     n x T  residuals of the mean response, their standard deviations
% DF       1 x T  degrees of freedom of the noise estimates
% P        n x 1, product over the targets that are calibrated; a curve is one
%
% Pr(|r + s t| < tolerance), t Student distributed. The surrogates of the points
% of a curve stand on the same runs: their errors are taken as one error, and
% it is the root mean square over the points that must be within.

function p = allMet (r, s, problem, df)
  p = ones (rows (r), 1);
  for requirement = requirementsOf (problem)
    t = requirement{1};
    tol = problem.tol(t);
    if isscalar (t)
      p = p .* insideProbability (r(:, t), s(:, t), tol, df(t));
    else
      p = p .* jointProbability (r(:, t) ./ tol, s(:, t) ./ tol, min (df(t)));
    end
  end
end

function p = insideProbability (r, s, tolerance, df)
  s = max (s, 1e-9 * tolerance);
  p = studentCdf ((tolerance - abs (r)) ./ s, df) - ...
      studentCdf ((-tolerance - abs (r)) ./ s, df);
end

% Pr(root mean square of r + s t < 1), one t for all points, in tolerances:
% mean ((r + s t)^2) <= 1 between the roots of a square.
function p = jointProbability (r, s, df)
  s = max (s, 1e-9);
  a = mean (s.^2, 2);
  b = mean (r .* s, 2);
  D = b.^2 - a .* (mean (r.^2, 2) - 1);
  root = sqrt (max (D, 0));
  p = studentCdf ((-b + root) ./ a, df) - studentCdf ((-b - root) ./ a, df);
  p(D < 0) = 0;
end

function p = studentCdf (x, df)
  if df > 1e5
    p = 0.5 * erfc (-x / sqrt (2));
    return
  end
  p = 0.5 * betainc (df ./ (df + x.^2), df / 2, 0.5);
  p(x > 0) = 1 - p(x > 0);
end

%!function p = met (r, s, tol, df, n)
%!  problem = struct ('tol', tol * ones (1, n), 'calibrate', true (1, n), ...
%!                    'curve', double (n > 1) * ones (1, n));
%!  p = allMet (repmat (r, 1, n), repmat (s, 1, n), problem, df * ones (1, n));
%!endfunction
%!assert (met (0, 1, 2.228139, 10, 1), 0.95, 1e-6)
%!assert (met (0, 1, 1.959964, Inf, 1), 0.95, 1e-6)
%!assert (met ([0; 3], [0; 0], 1, 5, 1), [1; 0], 1e-9)
%!test
%! % points that move together count once
%! r = [0; 0.5; -2];
%! s = [1; 0.3; 0.5];
%! assert (met (r, s, 2, 7, 9), met (r, s, 2, 7, 1), 1e-10);
%!test
%! % a target and a curve, each with degrees of freedom of its own
%! problem = struct ('tol', [0.1, 0.2, 0.2], 'calibrate', true (1, 3), ...
%!                   'curve', [0, 1, 1]);
%! p = allMet ([0.05, 0.1, 0.1], [0.05, 0.1, 0.1], problem, [4, 9, 11]);
%! assert (p, met (0.5, 0.5, 1, 4, 1) * met (0.5, 0.5, 1, 9, 1), 1e-10);
%! problem.calibrate(1) = false;
%! p = allMet ([9, 0.6, -0.6], [9, 0.02, 0.02], problem, [4, 9, 11]);
%! assert (p, 0);

% SPDX-License-Identifier: GPL-3.0-only
