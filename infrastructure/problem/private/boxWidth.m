% BOXWIDTH  How much of a parameter one width of the box is.
%
% CALL: W = boxWidth (LIMITS, P)
%
% LIMITS  2 x d, or 3 x d, the box, see toUnit
% P       n x d, where (in logarithms the width grows with the parameter)
% W       1 x d, or n x d: derivative of the parameter by its place in the
%         unit box

function w = boxWidth (limits, P)
  w = limits(2, :) - limits(1, :);
  isLog = any (limits(3:end, :), 1);
  if any (isLog)
    w = repmat (w, rows (P), 1);
    w(:, isLog) = P(:, isLog) .* log (limits(2, isLog) ./ limits(1, isLog));
  end
end

%!assert (boxWidth ([1, 4; 3, 8], [2, 5; 2, 6]), [2, 4]);
%!test
%! limits = [1, 0; 100, 2; 1, 0];
%! h = 1e-6;
%! X = fromUnit ([0.3; 0.3 + h] * [1, 1], limits);
%! assert (boxWidth (limits, X(1, :)), diff (X) / h, 1e-4);

% SPDX-License-Identifier: GPL-3.0-only
