% CURVESUMMARY  How well each curve that is fitted is met, in one number.
%
% CALL: CURVES = curveSummary (CASE, RESIDUAL)
%
%   CASE      see newCase
%   RESIDUAL  T x 1 or 1 x T, residuals of the targets
%   CURVES    1 x C struct: name (of the series), own (numbers of its
%             calibrated targets), share (root mean square of residual over
%             tolerance: the curve is met up to 1)

function curves = curveSummary (Case, residual)
  curves = struct ('name', {}, 'own', {}, 'share', {});
  [groups, ~, isJoint] = requirementsOf (Case.targets);
  for group = groups(isJoint)
    points = group{1};
    T = Case.targets(points);
    r = reshape (residual(points), 1, []);
    curves(end + 1) = struct ('name', T(1).series, 'own', points, 'share', ...
                              sqrt (mean ((r ./ [T.tol]).^2)));
  end
end

%!test
%! Case.targets = struct ('curve', {0, 1, 1, 1}, 'series', 'w', ...
%!                        'tol', {0.1, 0.2, 0.1, 0.1}, ...
%!                        'isAbsolute', false, ...
%!                        'role', {'calibrate', 'calibrate', 'calibrate', ...
%!                                 'unmeasured'});
%! c = curveSummary (Case, [9; 0.2; -0.1; NaN]);
%! assert (c.own, [2, 3]);
%! assert (c.share, 1, 1e-12);
%! [Case.targets.curve] = deal (0);
%! assert (isempty (curveSummary (Case, zeros (4, 1))));

% SPDX-License-Identifier: GPL-3.0-only
