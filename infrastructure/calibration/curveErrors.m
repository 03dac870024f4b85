% CURVEERRORS  What is known of the errors along each curve that is fitted.
%
% CALL: [CURVES, NFREE] = curveErrors (SURROGATES, PROBLEM)
%
% SURROGATES  1 x T struct array of fitSurrogates
% PROBLEM     struct of newProblem
% CURVES      1 x C struct, one element a curve of which points are calibrated:
%             points (1 x n, target numbers), value, sd (1 x n), distance (n x
%             n, between the points), rough, smooth (n x n, correlation of the
%             scatter of a run and of the errors of the surrogates), packingVar
%             (1 x n, noise of the mean of the trials), scatter (logical: sd
%             holds the packings), length (of the measurement's errors; NaN:
%             unknown), lengths (1 x 2, the range in question then), sdKnown,
%             half (1 x n, half widths of the tolerance), df, free (columns of
%             unknowns: of the length, of the size)
% NFREE       how many unknowns there are in all
%
% A run's own curve scatters as one, since it is one packing, and rough; what
% the surrogates do not know of the mean response is as smooth as the curve. The
% leave-one-out residuals hold both.

function [curves, nFree] = curveErrors (surrogates, problem)
  curves = [];
  nFree = 0;
  for number = unique (problem.curve(problem.calibrate & problem.curve > 0))
    points = find (problem.calibrate & problem.curve == number);
    place = problem.coordinate(points);
    c = struct ('points', points, 'value', problem.value(points), ...
                'sd', problem.sd(points), 'distance', abs (place' - place));
    c.packingVar = [surrogates(points).noiseVar] ./ problem.trials(points);
    c.scatter = any (problem.scatter(points));
    [c.rough, c.smooth] = correlations (looRows (surrogates(points)), ...
                                        c.distance);
    c.length = problem.correlation(points(1));
    steps = diff (unique (place));
    c.lengths = [min([steps, Inf]) / 3, max(place) - min(place)];
    if isempty (steps)
      c.length = 0;
    end
    c.sdKnown = all (c.sd > 0);
    c.half = problem.tol(points) .* abs (problem.scale(points));
    c.df = min ([surrogates(points).df]);
    nNew = isnan (c.length) + ~c.sdKnown;
    c.free = nFree + (1:nNew);
    nFree = nFree + nNew;
    curves = [curves, c];
  end
end

% Scatter exp (-distance / a), with the share w of the variance, and smooth
% errors exp (-(distance / b)^2): a, b and w of the largest likelihood on a
% grid. One correlation for both would be as rough as the scatter, and a set
% whose surrogates are unsure would be refused since the measured curve is too
% smooth for it.
function [rough, smooth] = correlations (E, distance)
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
    [a, b, share] = ndgrid (1:12, 1:12, [0.01, 0.03, 0.1, 0.3, 0.6, 1]);
    [~, best] = max (arrayfun (@(a, b, share) likelihood ...
                               (E, share * roughs{a} + ...
                                (1 - share) * smooths{b}), ...
                               a(:), b(:), share(:)));
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

%!function c = errors (E)
%!  at = linspace (0, 1, 20);
%!  s = struct ('looStd', mat2cell (E, rows (E), ones (1, 20)), ...
%!              'noiseVar', 4, 'df', 9);
%!  problem = struct ('calibrate', true (1, 20), 'curve', ones (1, 20), ...
%!                    'value', at, 'sd', zeros (1, 20), 'coordinate', at, ...
%!                    'trials', 2 * ones (1, 20), 'scatter', false (1, 20), ...
%!                    'correlation', NaN (1, 20), 'tol', 0.1 * ones (1, 20), ...
%!                    'scale', ones (1, 20));
%!  [c, nFree] = curveErrors (s, problem);
%!  assert ([nFree, c.free], [2, 1, 2]);
%!  problem.correlation(:) = 0.5;
%!  problem.sd(:) = 0.1;
%!  [~, nFree] = curveErrors (s, problem);
%!  assert (nFree, 0);
%!  problem.curve(:) = 0;
%!  assert (isempty (curveErrors (s, problem)));
%!endfunction
%!shared apart, draw
%! apart = abs (linspace (0, 1, 20)' - linspace (0, 1, 20));
%! draw = @(R) randn (40, 20) * chol (R + 1e-9 * eye (20));
%!test
%! % scatter alone, alike over a third of the curve (seeded; 60 of 60 others)
%! randn ('twister', 3);
%! c = errors (draw (exp (-apart / 0.3)));
%! assert (c.packingVar, 2 * ones (1, 20));
%! assert (c.rough(1, 8), exp (-7 / 19 / 0.3), 0.35);
%!test
%! % scatter beside a smooth error: the smooth one (seeded; 60 of 60 others)
%! randn ('twister', 5);
%! E = sqrt (0.1) * draw (exp (-apart / 0.2)) + ...
%!     sqrt (0.9) * draw (exp (-(apart / 0.5).^2));
%! assert (errors (E).smooth(1, 6), exp (-(5 / 19 / 0.5)^2), 0.15);
%!test
%! % no residuals: all alike
%! assert (errors (zeros (0, 20)).rough(1, 20), 1);
