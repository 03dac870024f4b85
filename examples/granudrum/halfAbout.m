% HALFABOUT  Half width of a 90 % interval whose middle is off.
%
% CALL: HALF = halfAbout (D, SD)
%
%   D     1 x m  mean of a normal variable, from the middle of the interval
%   SD    1 x m  its standard deviation
%   HALF  1 x m  the variable is within HALF of the middle with 90 %
%
% See also: predictSurfaces

function half = halfAbout (d, sd)
  lo = zeros (size (d));
  hi = abs (d) + 2 * sd;
  inside = @(h) (erf ((h - d) ./ sd / sqrt (2)) + ...
                 erf ((h + d) ./ sd / sqrt (2))) / 2;
  for i = 1:40
    half = (lo + hi) / 2;
    enough = inside (half) >= 0.9;
    hi(enough) = half(enough);
    lo(~enough) = half(~enough);
  end
end

%!assert (halfAbout (0, 1), 1.6449, 1e-4)
%!assert (halfAbout (-9, 2), 9 + 2 * 1.2816, 1e-3)

% SPDX-License-Identifier: GPL-3.0-only
