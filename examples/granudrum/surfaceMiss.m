% SURFACEMISS  How far surfaces are from the measured ones, at each speed.
%
% CALL: RMS = surfaceMiss (Z, Y)
%
%   Z    n x 2 p  heights of n runs (mm), the p places of 15 rpm, then of 45 rpm
%   Y    1 x 2 p  the measured ones
%   RMS  n x 2    root mean square at both speeds (mm); NaN where a run failed
%
% See also: compareSurfaces

function rms = surfaceMiss (Z, y)
  n = columns (Z) / 2;
  D2 = (Z - y).^2;
  rms = sqrt ([mean(D2(:, 1:n), 2), mean(D2(:, n + 1:end), 2)]);
end

% SPDX-License-Identifier: GPL-3.0-only
