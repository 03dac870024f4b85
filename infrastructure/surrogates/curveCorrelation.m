% CURVECORRELATION  How alike the errors of a surrogate are along a curve.
%
% CALL: [ROUGH, SMOOTH] = curveCorrelation (E, DISTANCE)
%
% E         n x p  leave-one-out residuals of n runs at the p points of a curve
% DISTANCE  p x p  between the points, in the unit of the axis
% ROUGH     p x p  correlation of the scatter of one run, which is one packing:
%                  exp (-distance / a)
% SMOOTH    p x p  that of what the surrogates do not know of the mean response,
%                  which is as smooth as the curve: exp (-(distance / b)^2)
%
% The residuals hold both, the scatter with the share w of the variance; a, b
% and w are those of the largest likelihood on a grid. One correlation for both
% would be as rough as the scatter, and a set whose surrogates are unsure would
% be refused since the measured curve is too smooth for it.

function [rough, smooth] = curveCorrelation (E, distance)
  [rough, smooth] = deal (ones (size (distance)));
  E = E(all (isfinite (E), 2), :);
  if ~isempty (E) && any (distance(:) > 0)
    E = E ./ max (sqrt (mean (E.^2, 1)), realmin);
    steps = [min(distance(distance > 0)), 3 * max(distance(:))];
    short = logspace (log10 (steps(1) / 3), log10 (steps(2)), 12);
    long = logspace (log10 (steps(1)), log10 (steps(2)), 12);
    roughs = arrayfun (@(a) exp (-distance / a), short, ...
                       'UniformOutput', false);
    smooths = arrayfun (@(b) exp (-(distance / b).^2), long, ...
                        'UniformOutput', false);
    [a, b, w] = ndgrid (1:12, 1:12, [0.01, 0.03, 0.1, 0.3, 0.6, 1]);
    [~, best] = max (arrayfun (@(a, b, w) likelihood ...
                               (E, w * roughs{a} + (1 - w) * smooths{b}), ...
                               a(:), b(:), w(:)));
    rough = roughs{a(best)};
    smooth = smooths{b(best)};
  end
  onDiagonal = 1:rows (distance) + 1:numel (distance);
  rough(onDiagonal) = 1 + 1e-6;
  smooth(onDiagonal) = 1 + 1e-6;
end

% Logarithmic, with the variance of the largest likelihood.
function fit = likelihood (E, R)
  [n, m] = size (E);
  R(1:m + 1:end) = 1 + 1e-6;
  [root, flaw] = chol (R, 'lower');
  fit = -Inf;
  if ~flaw
    fit = -n * m / 2 * log (sum (sumsq (root \ E')) / (n * m)) - ...
          n * sum (log (diag (root)));
  end
end

%!shared at, apart, draw
%! at = linspace (0, 1, 20);
%! apart = abs (at' - at);
%! draw = @(R) randn (40, 20) * chol (R + 1e-9 * eye (20));
%!test
%! % scatter alone, alike over a third of the curve (seeded; 60 of 60 others)
%! randn ('twister', 3);
%! rough = curveCorrelation (draw (exp (-apart / 0.3)), apart);
%! assert (rough(1, 8), exp (-7 / 19 / 0.3), 0.35);
%!test
%! % scatter beside a smooth error: the smooth one (seeded; 60 of 60 others)
%! randn ('twister', 5);
%! E = sqrt (0.1) * draw (exp (-apart / 0.2)) + ...
%!     sqrt (0.9) * draw (exp (-(apart / 0.5).^2));
%! [~, smooth] = curveCorrelation (E, apart);
%! assert (smooth(1, 6), exp (-(5 / 19 / 0.5)^2), 0.15);
%!test
%! % no residuals, or one point: all alike
%! assert (curveCorrelation (zeros (0, 20), apart)(1, 20), 1);
%! assert (curveCorrelation (1, 0), 1 + 1e-6);
