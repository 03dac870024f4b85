% FALLSLOWING  Speed of a grain that fell through air over that in a vacuum.
%
% CALL: F = fallSlowing (HEIGHT, DRAG)
%
%   HEIGHT  of the fall (m)
%   DRAG    gravity over the square of the terminal velocity (1/m): g / vt^2
%   F       in (0, 1], shape of HEIGHT .* DRAG, exactly 1 without drag
%
% v = vt sqrt (1 - exp (-2 g h / vt^2)) for drag that grows with v^2.
%
% See also: foreignLab

function F = fallSlowing (height, drag)
  x = 2 * height .* drag;
  F = ones (size (x));
  has = x ~= 0;
  F(has) = sqrt (-expm1 (-x(has)) ./ x(has));
end

%!test
%! assert (fallSlowing ([0, 1], [3, 0]), [1, 1]);
%! v = fallSlowing (1000, 9.81 / 4^2) * sqrt (2 * 9.81 * 1000);
%! assert (v, 4, 1e-9);
%! assert (all (diff (fallSlowing (0.3, 0:5)) < 0));
