% NICETICKS  Round numbers on an axis.
%
% CALL: AT = niceTicks (RANGE, N)
%
%   RANGE  1 x 2, ends of the axis
%   N      about so many
%   AT     row, multiples of 1, 2 or 5 times a power of ten inside RANGE
%
% See also: drawFigures

function at = niceTicks (range, n)
  raw = diff (range) / max (n, 1);
  power = 10^floor (log10 (raw));
  steps = [1, 2, 5, 10];
  step = power * steps(find (steps * power >= 0.7 * raw, 1));
  at = step * (ceil (range(1) / step - 1e-9):floor (range(2) / step + 1e-9));
  at(abs (at) < step * 1e-6) = 0;
end

%!assert (niceTicks ([0, 1], 4), 0:0.2:1, 1e-12)
%!assert (niceTicks ([395.9, 404.1], 4), 396:2:404, 1e-9)
%!assert (niceTicks ([0, 1], 5), 0:0.2:1, 1e-12)
%!assert (niceTicks ([-0.3, 0.27], 3), [-0.2, 0, 0.2], 1e-12)
%!assert (niceTicks ([500, 800], 3), 500:100:800)
