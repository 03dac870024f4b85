% SOLVESTART  One Levenberg-Marquardt solution on the surrogates.
%
% CALL: [SOLVED, PATH] = solveStart (SURROGATES, PROBLEM, START, MAXITER,
%                                    MAXEVALS)
%
% START     struct: start (name), params 1 x d
% MAXITER   most iterations; MAXEVALS  most evaluations, counted here because
%           nonlin_residmin does not (a Jacobian counts 2 d)
% SOLVED    struct: start, params 1 x d, norm (largest residual in tolerances),
%           within, probability, evaluations, iterations, reason
% PATH      1 x k struct: iteration, params, residual (T x 1)
%
% Only the rows of the calibrated targets are minimised, in units of their
% tolerance, a curve as one target; preference rows never take part.

function [solved, path] = solveStart (surrogates, problem, start, ...
                                      maxIter, maxEvals)
  lo = problem.limits(1, :);
  width = problem.limits(2, :) - lo;
  scaled = @(u) unitResidual (surrogates, problem, lo + u(:)' .* width);
  jacobian = @(u, hook) surrogateJacobian (surrogates, problem, ...
                                           lo + u(:)' .* width);
  d = numel (lo);
  limit = max (1, min (maxIter, floor (maxEvals / (2 * d + 2))));
  settings = optimset ('MaxIter', limit, 'TolFun', 1e-6);
  u = (start.params(:) - lo(:)) ./ width(:);
  u = min (max (u, 0), 1);
  if sum (scaled (u).^2) > eps (1)
    [u, cvg, niter] = leastSquaresInBox (scaled, jacobian, u, settings);
  else
    cvg = 3;
    niter = 0;
  end
  p = lo + u(:)' .* width;
  [probability, r] = meetProbability (surrogates, problem, p);
  solved = start;
  solved.params = p;
  solved.norm = max (toleranceShare (problem, r));
  solved.within = solved.norm <= 1;
  solved.probability = probability;
  solved.evaluations = 1 + niter * (2 * d + 1);
  solved.iterations = niter;
  solved.reason = convergence (cvg);
  path = struct ('iteration', {0, niter}, ...
                 'params', {start.params, p}, 'residual', {[], r'});
  path(1).residual = targetResidual (problem, start.params, ...
                                     predictSurrogate (surrogates, ...
                                                       start.params))';
end

function f = unitResidual (surrogates, problem, p)
  r = targetResidual (problem, p, predictSurrogate (surrogates, p));
  use = problem.calibrate;
  f = (r(use) ./ problem.part(use))';
end

function text = convergence (cvg)
  switch cvg
    case 3
      text = 'the sum of squares no longer decreases';
    case 2
      text = 'the parameters no longer change';
    case 0
      text = 'limit of iterations or evaluations';
    otherwise
      text = 'stopped';
  end
end

%!shared problem, state, s
%! [problem, state, s] = smallCalibration ();

%!test
%! % the solution of two equations: a + b/2 = 1, a + b/2.5 = 1 => a 1, b 0
%! start = struct ('start', 'here', 'params', [0.2, 1.5]);
%! [solved, path] = solveStart (s, problem, start, 100, 1000);
%! assert (solved.norm < 0.1);
%! assert (solved.within);
%! assert (solved.evaluations <= 1000);
%! assert (numel (path), 2);

%!test
%! % the limit of evaluations holds
%! start = struct ('start', 'here', 'params', [0.2, 1.5]);
%! solved = solveStart (s, problem, start, 100, 12);
%! assert (solved.evaluations <= 12);
