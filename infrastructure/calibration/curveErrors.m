% CURVEERRORS  What is known of the errors along each curve that is fitted.
%
% CALL: [CURVES, NFREE] = curveErrors (SURROGATES, PROBLEM)
%
% SURROGATES  1 x T struct array of fitSurrogates
% PROBLEM     struct of newProblem
% CURVES      1 x C struct, one element a curve of which points are calibrated:
%             own (1 x n, target numbers), value, sd (1 x n), distance (n x n,
%             between the points), rough, smooth (n x n, correlation of the
%             scatter of a run and of the errors of the surrogates),
%             packingVar (1 x n, noise of the mean of the trials), scatter
%             (logical: sd holds the packings), length (of the measurement's
%             errors; NaN: unknown), lengths (1 x 2, the range in question
%             then), sdKnown, half (1 x n, half widths of the tolerance), df,
%             free (columns of unknowns: of the length, of the size)
% NFREE       how many unknowns there are in all
%
% A run's own curve scatters as one, since it is one packing; the errors of the
% surrogates are smooth. How far each is alike follows from the leave-one-out
% residuals (curveCorrelation).

function [curves, nFree] = curveErrors (surrogates, problem)
  curves = [];
  nFree = 0;
  for number = unique (problem.curve(problem.calibrate & problem.curve > 0))
    own = find (problem.calibrate & problem.curve == number);
    at = problem.coordinate(own);
    c = struct ('own', own, 'value', problem.value(own), ...
                'sd', problem.sd(own), 'distance', abs (at' - at));
    c.packingVar = [surrogates(own).noiseVar] ./ problem.trials(own);
    c.scatter = any (problem.scatter(own));
    [c.rough, c.smooth] = curveCorrelation (looRows (surrogates(own)), ...
                                            c.distance);
    c.length = problem.correlation(own(1));
    steps = diff (unique (at));
    c.lengths = [min([steps, Inf]) / 3, max(at) - min(at)];
    if isempty (steps)
      c.length = 0;
    end
    c.sdKnown = all (c.sd > 0);
    c.half = problem.tol(own) .* abs (problem.scale(own));
    c.df = min ([surrogates(own).df]);
    nNew = isnan (c.length) + ~c.sdKnown;
    c.free = nFree + (1:nNew);
    nFree = nFree + nNew;
    curves = [curves, c];
  end
end

%!test
%! % scatter that is alike over a third of the curve (seeded)
%! randn ('twister', 3);
%! at = linspace (0, 1, 20);
%! E = randn (30, 20) * chol (exp (-abs (at' - at) / 0.3) + 1e-9 * eye (20));
%! s = struct ('looStd', mat2cell (E, 30, ones (1, 20)), 'noiseVar', 4, ...
%!             'df', 9);
%! problem = struct ('calibrate', true (1, 20), 'curve', ones (1, 20), ...
%!                   'value', at, 'sd', zeros (1, 20), 'coordinate', at, ...
%!                   'trials', 2 * ones (1, 20), 'scatter', false (1, 20), ...
%!                   'correlation', NaN (1, 20), 'tol', 0.1 * ones (1, 20), ...
%!                   'scale', ones (1, 20));
%! [c, nFree] = curveErrors (s, problem);
%! assert (nFree, 2);
%! assert (c.free, [1, 2]);
%! assert (c.packingVar, 2 * ones (1, 20));
%! assert (c.rough(1, 8), exp (-7 / 19 / 0.3), 0.35);
%! problem.correlation(:) = 0.5;
%! problem.sd(:) = 0.1;
%! [c, nFree] = curveErrors (s, problem);
%! assert (nFree, 0);
%! problem.curve(:) = 0;
%! assert (isempty (curveErrors (s, problem)));
