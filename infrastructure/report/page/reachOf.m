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
  P = [limits(1, :) + u .* diff(limits); insideLimits(s.X, limits)];
  m = predictSurrogate (s, P);
  range = [min(m), max(m)];
end
