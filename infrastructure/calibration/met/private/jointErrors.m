% JOINTERRORS  What is known of the errors along each curve that is fitted.
%
% CALL: [JOINT, NFREE, ALONE] = jointErrors (SURROGATES, PROBLEM)
%
% JOINT       1 x C struct, one element a curve of which points are calibrated:
%             points (1 x p, target numbers), free (columns of unknowns) and
%             logLikelihood, handle (M, V, FREE) -> n x 1, log density of the
%             measured curve, and n x 1, its level as a normal score: M, V n x p, mean and
%             variance of the surrogates at the points; FREE n x f in [0, 1], the
%             length over which the
%             errors of the measurement are alike (a third of a step to the
%             whole curve, logarithmic), then their size (2 % to twice the
%             tolerance, logarithmic), each where it is not known; weight (p x 1,
%             of the points in the level) and share (scalar, of the variance of the
%             level that is of the packing)
% NFREE       how many unknowns there are in all
% ALONE       1 x s, numbers of the calibrated targets that are on no curve
%
% A run's own curve scatters as one, since it is one packing, and rough; what
% the surrogates do not know of the mean response is as smooth as the curve. The
% leave-one-out residuals hold both.
%
% Covariance: sd_i sd_j exp (-distance / length) of the measurement, less what
% the sessions make of it (PROBLEM.shared), which the whole curve shares; of one
% packing, its standard deviations times the rough correlation; of the
% surrogates, sqrt (v_i v_j) times the smooth one. The last two are widened to
% the variance of a Student variable. No Student density of the whole curve: its
% one unknown scale would be learned from the curve itself, which few runs fit
% well where the surrogates are wrong (closed study curveFewRuns.m).

function [joint, nFree, alone] = jointErrors (surrogates, problem)
  joint = [];
  nFree = 0;
  [groups, ~, isJoint] = requirementsOf (problem);
  alone = [groups{~isJoint}];
  for group = groups(isJoint)
    points = group{1};
    place = problem.coordinate(points);
    steps = diff (unique (place));
    fits = surrogates(points);
    c = struct ('points', points, 'value', problem.value(points), ...
                'sd', problem.statedSd(points), 'distance', abs (place' - place));
    c.shared = givenField (problem, 'shared', 0 * problem.statedSd)(points);
    c.own = sqrt (max (c.sd.^2 - c.shared.^2, 0));
    c.packingVar = [fits.noiseVar] ./ problem.trials(points);
    c.scatter = any (problem.scatter(points));
    [c.rough, c.smooth] = correlations (looRows (fits), c.distance);
    c.length = problem.correlation(points(1));
    if isempty (steps)
      c.length = 0;
    end
    c.lengths = [min([steps, Inf]) / 3, max(place) - min(place)];
    c.sdKnown = all (c.sd > 0);
    c.half = problem.tol(points) .* abs (problem.scale(points));
    c.df = min ([fits.df]);
    nNew = isnan (c.length) + ~c.sdKnown;
    c.free = nFree + (1:nNew);
    nFree = nFree + nNew;
    c.weight = c.rough \ ones (numel (points), 1);
    c.share = packingShare (c);
    c.logLikelihood = @(m, v, free) likelihoodOf (c, m, v, free);
    joint = [joint, c];
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
    [a, b, share] = ndgrid (short, long, [0.01, 0.03, 0.1, 0.3, 0.6, 1]);
    fits = arrayfun (@(a, b, share) ...
                     correlationFit (E, share * exp (-distance / a) + ...
                                     (1 - share) * exp (-(distance / b).^2)), ...
                     a(:), b(:), share(:));
    [~, best] = max (fits);
    rough = exp (-distance / a(best));
    smooth = exp (-(distance / b(best)).^2);
  end
  [rough, smooth] = deal (surely (rough), surely (smooth));
end

% That rounding does not make a correlation singular.
function R = surely (R)
  R(1:rows (R) + 1:end) = 1 + 1e-6;
end

% With what is not known in the middle.
function share = packingShare (c)
  unknown = numel (c.length(isnan (c.length))) + ~c.sdKnown;
  own = covariance (c, 0.5 * ones (1, unknown)) * ~c.scatter + c.shared' * c.shared;
  sd = sqrt (c.packingVar);
  packing = c.weight' * ((sd' * sd) .* c.rough) * c.weight;
  share = packing / max (packing + c.weight' * own * c.weight, realmin);
end

% Normal log density at each set, see above.
function [fit, level] = likelihoodOf (c, m, v, free)
  n = rows (m);
  [fit, level] = deal (zeros (n, 1));
  packing = c.packingVar;
  if c.scatter
    % the scatter of the trials holds their packings
    packing = max (packing - c.own.^2, 0);
  end
  df = max (c.df, 3);
  wider = df / (df - 2);
  packingSd = sqrt (wider * packing);
  fixed = (packingSd' * packingSd) .* c.rough + c.shared' * c.shared;
  surrogateSd = sqrt (wider * v + eps (max (c.value.^2)));
  S = [];
  for i = 1:n
    if isempty (S) || ~isempty (free)
      S = covariance (c, free(i, :));
    end
    sd = surrogateSd(i, :);
    root = chol (S + fixed + (sd' * sd) .* c.smooth);
    r = c.value - m(i, :);
    fit(i) = -sum (log (diag (root))) - 0.5 * sumsq (r / root);
    level(i) = r * c.weight / norm (root * c.weight);
  end
end

% The unknowns: first the length, then the size, where they are not known.
function S = covariance (c, free)
  if isnan (c.length)
    c.length = c.lengths(1) * (c.lengths(2) / c.lengths(1))^free(1);
  end
  R = full (eye (rows (c.distance)));
  if c.length > 0
    R = exp (-c.distance / c.length);
  end
  sd = c.own;
  if ~c.sdKnown
    sd = c.half * 0.02 * 100^free(end);
  end
  S = (sd' * sd) .* surely (R);
end

%!function c = errors (E)
%!  at = linspace (0, 1, 20);
%!  s = struct ('looStd', mat2cell (E, rows (E), ones (1, 20)), ...
%!              'noiseVar', 4, 'df', 9);
%!  problem = struct ('calibrate', true (1, 20), 'curve', ones (1, 20), ...
%!                    'value', at, 'statedSd', zeros (1, 20), 'coordinate', at, ...
%!                    'trials', 2 * ones (1, 20), 'scatter', false (1, 20), ...
%!                    'correlation', NaN (1, 20), 'tol', 0.1 * ones (1, 20), ...
%!                    'scale', ones (1, 20));
%!  [c, nFree] = jointErrors (s, problem);
%!  assert ([nFree, c.free], [2, 1, 2]);
%!  problem.correlation(:) = 0.5;
%!  problem.statedSd(:) = 0.1;
%!  [~, nFree] = jointErrors (s, problem);
%!  assert (nFree, 0);
%!  problem.curve(:) = 0;
%!  assert (isempty (jointErrors (s, problem)));
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

%!function fit = density (changes, m, v, free)
%!  n = numel (m);
%!  s = repmat (struct ('looStd', zeros (0, 1), 'noiseVar', 4, 'df', 7), 1, n);
%!  problem = struct ('calibrate', true (1, n), 'curve', ones (1, n), ...
%!                    'value', 2 * ones (1, n), 'statedSd', 3 * ones (1, n), ...
%!                    'coordinate', 1e-6 * (1:n), 'trials', ones (1, n), ...
%!                    'scatter', false (1, n), 'correlation', ones (1, n), ...
%!                    'tol', 5 * ones (1, n), 'scale', ones (1, n));
%!  c = jointErrors (s, mergeFields (problem, changes));
%!  fit = c.logLikelihood (m, v, free);
%!endfunction

%!test
%! % of one point: normal, what the runs tell widened by 7 / 5
%! f = @(v) -0.5 * log (v) - 0.5 * (2 - 0.5)^2 / v;
%! none = zeros (1, 0);
%! assert (density (struct (), 0.5, 3, none), f (18.8), 1e-5);
%! assert (density (struct ('scatter', true), 0.5, 3, none), f (13.2), 1e-5);
%! % size unknown: half way between 0.1 and 10
%! assert (density (struct ('statedSd', 0), 0.5, 3, 0.5), f (10.8), 1e-5);

%!test
%! % two points that move together weigh as one, also by the day they are of
%! fall = @(changes) density (changes, [2, 2], [0, 0], zeros (1, 0)) - ...
%!                   density (changes, [5, 5], [0, 0], zeros (1, 0));
%! sure = struct ('trials', [Inf, Inf]);
%! assert (fall (sure), 0.5, 1e-3);
%! assert (fall (setfield (sure, 'correlation', [0, 0])), 1, 1e-3);
%! sure.shared = [3, 3];
%! assert (fall (setfield (sure, 'correlation', [0, 0])), 0.5, 1e-3);

% SPDX-License-Identifier: GPL-3.0-only
