% TOLERANCESHARE  How much of its tolerance each requirement uses up.
%
% CALL: [SHARE, SPREAD] = toleranceShare (PROBLEM, R, S)
%
%   PROBLEM  struct of newProblem
%   R        n x T, residuals
%   S        n x T, their standard deviations; needed for SPREAD only
%   SHARE    n x G, one column a requirement of the targets that are
%            calibrated, see requirementsOf: abs (residual) / tolerance of a
%            target, the root mean square of these over the points of a curve.
%            It is met up to 1
%   SPREAD   n x G, the same of S

function [share, spread] = toleranceShare (problem, r, s)
  groups = requirementsOf (problem);
  share = zeros (rows (r), numel (groups));
  spread = share;
  for g = 1:numel (groups)
    group = groups{g};
    share(:, g) = rms2 (r(:, group) ./ problem.tol(group));
    if nargin > 2
      spread(:, g) = rms2 (s(:, group) ./ problem.tol(group));
    end
  end
end

function x = rms2 (A)
  if columns (A) == 1
    x = abs (A);
  else
    x = sqrt (mean (A.^2, 2));
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
