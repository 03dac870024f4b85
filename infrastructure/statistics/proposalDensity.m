% PROPOSALDENSITY  Log density of a proposal: 0.9 Student t mixture, 0.1 prior.
%
% CALL: L = proposalDensity (PARTS, U)
%
%   PARTS  1 x m struct mean, root (see studentDensity), share (sum 1)
%   U      n x d, normal coordinates
%   L      n x 1

function L = proposalDensity (parts, U)
  d = columns (U);
  densities = zeros (rows (U), numel (parts) + 1);
  densities(:, 1) = log (0.1) - 0.5 * sum (U.^2, 2) - d / 2 * log (2 * pi);
  for m = 1:numel (parts)
    densities(:, m + 1) = log (0.9 * parts(m).share) + ...
                          studentDensity (parts(m), U);
  end
  L = logSumExp (densities);
end

%!test
%! part = struct ('mean', 1, 'root', 0.5, 'share', 1);
%! x = (-30:0.01:30)';
%! assert (trapz (x, exp (proposalDensity (part, x))), 1, 1e-3);
