% TOLERANCESHARE  How much of its tolerance each requirement uses up.
%
% CALL: [SHARE, SPREAD] = toleranceShare (PROBLEM, R, S)
%
%   R        n x T, residuals
%   S        n x T, their standard deviations; needed for SPREAD only
%   SHARE    n x G, one column a requirement of the targets that are
%            calibrated, see requirementsOf: abs (residual) / tolerance of a
%            target, the root mean square of these over the points of a curve.
%            It is met up to 1
%   SPREAD   n x G, the same of S

function [share, spread] = toleranceShare (problem, r, s)
  groups = requirementsOf (problem);
  share = sizes (r, problem, groups);
  if nargin > 2
    spread = sizes (s, problem, groups);
  end
end

function share = sizes (r, problem, groups)
  share = zeros (rows (r), numel (groups));
  for g = 1:numel (groups)
    t = groups{g};
    parts = r(:, t) ./ problem.tol(t);
    share(:, g) = abs (parts(:, 1));
    if numel (t) > 1
      share(:, g) = sqrt (mean (parts.^2, 2));
    end
  end
end

%!test
%! problem = struct ('tol', [0.1, 0.2, 0.2, 0.1], 'curve', [0, 1, 1, 0], ...
%!                   'calibrate', [true, true, true, false]);
%! [share, spread] = toleranceShare (problem, [-0.1, 0.2, -0.2, 9; ...
%!                                             0.05, 0.6, 0, 9], ...
%!                                   [0.1, 0.2, 0.2, 9; 0, 0, 0, 9]);
%! assert (share, [1, 1; 0.5, sqrt(4.5)], 1e-12);
%! assert (spread, [1, 1; 0, 0], 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
