% SHORTESTINTERVAL  Gives median and shortest interval of a weighted sample.
%
% CALL: Q = shortestInterval (X, WEIGHT, SHARE, RANGE)
%
%   X        n x 1, samples;  WEIGHT  n x 1, weights >= 0
%   SHARE    scalar, what the interval holds (0.9)
%   RANGE    1 x 2, limits of X
%   Q        1 x 3: median, lower and upper end
%
% Where less than a hundredth of the weight lies beyond an end the interval goes
% to the limit: a strength at the end of its range would never be inside an
% interval of quantiles.
%
% See also: weightedQuantile, weighCase

function q = shortestInterval (x, weight, share, range)
  [x, order] = sort (x(:));
  weight = weight(order);
  whole = cumsum (weight(:)) / sum (weight);
  first = [1; find(diff (x) > 0) + 1];
  below = [0; whole(1:end - 1)];
  below = below(first);
  last = lookup (whole, below + share - 1e-12) + 1;
  inside = last <= numel (x);
  first = first(inside);
  last = last(inside);
  below = below(inside);
  lo = x(first);
  hi = x(last);
  lo(below < 0.01) = range(1);
  hi(whole(last) > 0.99) = range(2);
  [~, best] = min (x(last) - x(first));
  q = [weightedQuantile(x, weight, 0.5), lo(best), hi(best)];
end

%!test
%! % a ramp: its shortest interval reaches the limit where it is densest
%! x = sqrt (((1:2000)' - 0.5) / 2000);
%! q = shortestInterval (x, ones (2000, 1), 0.9, [0, 1]);
%! assert (q, [sqrt(0.5), sqrt(0.1), 1], 0.02);
%!test
%! % a normal sample: the same as its quantiles
%! x = sqrt (2) * erfinv (2 * ((1:4000)' - 0.5) / 4000 - 1);
%! q = shortestInterval (x, ones (4000, 1), 0.9, [-9, 9]);
%! assert (q, [0, -1.645, 1.645], 0.03);
