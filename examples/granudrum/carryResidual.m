% CARRYRESIDUAL  Surface at another speed: simulated, plus what is missed.
%
% CALL: [Z, HALF] = carryResidual (SIM, R, W, CHANGE, SD)
%
%   SIM     n x m   simulated surfaces at the other speed (mm), a row a set that
%                   fits
%   R       1 x k cell of n x m, measured minus simulated of the same sets at
%                   the k measured speeds (mm)
%   W       1 x k   weights of these speeds, of sum 1
%   CHANGE  scalar or 1 x m, standard deviation of what the residual may change
%           by beyond the weights (mm)
%   SD      scalar  standard deviation of what a measured surface has of its own
%                   (mm)
%   Z       1 x m   mean of SIM + sum W R
%   HALF    1 x m   half width of the 90 % interval that is to hold the surface
%                   as it would be measured
%
% Variance: of the rows (parameters and packing), CHANGE^2, and SD^2 (1 +
% sum W^2): the residuals hold the errors of their measurements, the surface in
% question has its own. An error that all readings of the instrument share is in
% the residuals and in the surface alike and cancels, for the weights have the
% sum 1.
%
% See also: predictSurfaces, checkCarry

function [z, half] = carryResidual (sim, r, w, change, sd)
  whole = sim;
  for k = 1:numel (w)
    whole = whole + w(k) * r{k};
  end
  z = mean (whole, 1);
  half = 1.645 * sqrt (var (whole, 0, 1) + change.^2 + ...
                       sd^2 * (1 + sumsq (w)));
end

%!test
%! [z, half] = carryResidual ([1, 2; 3, 4], {[1, 1; -1, -1], [0, 2; 2, 0]}, ...
%!                            [0.5, 0.5], 3, 2);
%! assert (z, [2.5, 3.5]);
%! assert (half, 1.645 * sqrt ([2, 0] + 9 + 6), 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
