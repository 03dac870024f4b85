% INSIDEPROBABILITY  Pr(|r + s t| < tolerance), t Student distributed.
%
% CALL: P = insideProbability (R, S, TOLERANCE, DF)
%
% R, S       n x 1  centre and scale
% TOLERANCE  scalar > 0
% DF         scalar, degrees of freedom
% P          n x 1
%
% See also: studentCdf, meetProbability

function p = insideProbability (r, s, tolerance, df)
  s = max (s, 1e-9 * tolerance);
  p = studentCdf ((tolerance - abs (r)) ./ s, df) - ...
      studentCdf ((-tolerance - abs (r)) ./ s, df);
end

%!assert (insideProbability (0, 1, 2.228139, 10), 0.95, 1e-6)
%!assert (insideProbability ([0; 3], [0; 0], 1, 5), [1; 0], 1e-9)
