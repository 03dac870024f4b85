% CURVEPROBABILITY  Pr(root mean square of r + s t < 1), one t for all points.
%
% CALL: P = curveProbability (R, S, DF)
%
% R, S  n x m  residuals of the points of a curve and their standard
%              deviations, in tolerances
% DF    scalar, degrees of freedom
% P     n x 1
%
% The surrogates of the points of a curve stand on the same runs: their errors
% are taken as one error, t Student distributed. Of a single point this is
% insideProbability.
%
% See also: insideProbability, meetProbability

function p = curveProbability (r, s, df)
  s = max (s, 1e-9);
  % mean ((r + s x)^2) <= 1 between the roots of a square
  a = mean (s.^2, 2);
  b = mean (r .* s, 2);
  c = mean (r.^2, 2) - 1;
  D = b.^2 - a .* c;
  root = sqrt (max (D, 0));
  p = studentCdf ((-b + root) ./ a, df) - studentCdf ((-b - root) ./ a, df);
  p(D < 0) = 0;
end

%!test
%! r = [0; 0.5; -2];
%! s = [1; 0.3; 0.5];
%! assert (curveProbability (r, s, 7), insideProbability (r, s, 1, 7), 1e-10);
%! % points that move together count once
%! assert (curveProbability (repmat (r, 1, 9), repmat (s, 1, 9), 7), ...
%!         insideProbability (r, s, 1, 7), 1e-10);
%! assert (curveProbability ([3, -3], [0.1, 0.1], 7), 0);
