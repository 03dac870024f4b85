% REACHOF  Between which values a response can be brought inside the box.
%
% CALL: RANGE = reachOf (PAGE, T)
%
%   PAGE   see pageData
%   T      number of the target
%   RANGE  1 x 2, least and largest mean response of its surrogate over the runs
%          and 500 points of the box; NaN without surrogates
%
% See also: benchFigure, sectionTargets

function range = reachOf (page, t)
  range = [NaN, NaN];
  if isempty (page.surrogates)
    return
  end
  s = page.surrogates(t);
  limits = page.Case.limits;
  u = integrationPoints (500, columns (limits), 1).uniform;
  isInside = all (s.X >= limits(1, :) & s.X <= limits(2, :), 2);
  P = [limits(1, :) + u .* diff(limits); s.X(isInside, :)];
  m = predictSurrogate (s, P);
  range = [min(m), max(m)];
end

%!test
%! [problem, ~, s] = smallCalibration ();
%! page = struct ('Case', struct ('limits', problem.limits), 'surrogates', s);
%! % x = 3 + a + b / 2, a up to 1, b up to 2; noise 0.3 %
%! assert (reachOf (page, 1), [3, 5], 0.1);
%! page.surrogates = [];
%! assert (reachOf (page, 1), [NaN, NaN]);
