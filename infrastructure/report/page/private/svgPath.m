% SVGPATH  A line through points, as the d of a path of SVG.
%
% CALL: TEXT = svgPath (X, Y)
%
%   X, Y  n x 1, px; the line is broken where one is not finite
%   TEXT  'M1.0 2.0L3.0 4.0'

function text = svgPath (x, y)
  isThere = isfinite (x(:)) & isfinite (y(:));
  pen = 'ML';
  pens = pen(1 + (isThere & [false; isThere(1:end - 1)]));
  list = [num2cell(pens(:)), num2cell(x(:)), num2cell(y(:))]';
  text = sprintf ('%s%.1f %.1f', list{:, isThere});
end

%!assert (svgPath ([1, 2, NaN, 4], [1, 2, 3, 4]), 'M1.0 1.0L2.0 2.0M4.0 4.0')
%!assert (isempty (svgPath ([], [])))

% SPDX-License-Identifier: GPL-3.0-only
