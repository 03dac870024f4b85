% LEASTSQUARESINBOX  Least squares of some residuals inside the unit box.
%
% CALL: [U, CVG, NITER] = leastSquaresInBox (F, J, U, SETTINGS)
%
%   F         handle r = f (u), u d x 1 in the unit box
%   J         handle of its Jacobian, j = J (u, hook)
%   U         d x 1, the start; the solution
%   SETTINGS  of optimset: MaxIter, TolFun
%   CVG       how it ended, as nonlin_residmin says it
%   NITER     iterations
%
% nonlin_residmin of optim. With fewer residuals than parameters its search for
% the active bounds (cpiv_bard) goes round in circles on rounding errors: it
% gives up ('not successful', 'pivot is zero') or stops where a step downhill
% inside the box is left. Then a pull to the start, 0.1 in residuals for a side
% of the box, makes the problem regular; a constant residual of 0.01 ends the
% search where only the pull is left to gain. The better of the two is taken.
%
% Errors: those of F and of nonlin_residmin

function [u, cvg, niter] = leastSquaresInBox (f, J, u, settings)
  d = numel (u);
  start = u;
  settings = optimset (settings, 'lbound', zeros (d, 1), ...
                       'ubound', ones (d, 1));
  try
    [u, cvg, niter] = search (f, J, start, settings);
    stuck = leavesSlope (f (u), J (u, []), u);
  catch err
    if ~any (strcmp (err.message, {'not successful', 'pivot is zero'}))
      rethrow (err);
    end
    stuck = true;
  end
  if stuck
    pull = [0.1 * eye(d); zeros(1, d)];
    pulled = @(u) [f(u); pull * (u - start) + [zeros(d, 1); 0.01]];
    slope = @(u, hook) [J(u, hook); pull];
    [v, pulledCvg, pulledNiter] = search (pulled, slope, start, settings);
    if sumsq (f (v)) <= sumsq (f (u))
      u = v;
      cvg = pulledCvg;
      niter = pulledNiter;
    end
  end
end

function [u, cvg, niter] = search (f, J, u, settings)
  [u, ~, cvg, info] = nonlin_residmin (f, u, optimset (settings, 'dfdp', J));
  u = min (max (u, 0), 1);
  niter = info.niter;
end

% Would a step down the steepest slope, safe for the linear model, gain 0.1 %?
function yes = leavesSlope (r, J, u)
  step = min (max (u - J' * r / sumsq (J(:)), 0), 1) - u;
  yes = sumsq (r + J * step) < 0.999 * sumsq (r);
end

%!test
%! % from a corner, two residuals of five parameters: 'not successful' in optim
%! pkg load -nodeps struct optim
%! J = [-2.653,  -2.439, 11.3,    0.008219,  0.8051; ...
%!       1.208,  11.02,  -4.094, -55.56,    -0.0003814];
%! start = [1; 1; 1; 0.7739; 0];
%! f = @(u) [-4.193; 7.254] + J * (u - start);
%! settings = optimset ('MaxIter', 60, 'TolFun', 1e-6);
%! [u, ~, niter] = leastSquaresInBox (f, @(u, hook) J, start, settings);
%! assert (norm (f (u)) < 0.01 && niter > 0);
%! assert (all (u >= 0 & u <= 1));

%!test
%! % fewer residuals than parameters, residuals of 0 inside the box: alone,
%! % nonlin_residmin stops short of them in most of these
%! pkg load -nodeps struct optim
%! rand ('seed', 1);
%! randn ('seed', 1);
%! settings = optimset ('MaxIter', 60, 'TolFun', 1e-6);
%! for k = 1:40
%!   J = randn (2, 5) .* exp (randn (2, 5));
%!   truth = rand (5, 1);
%!   f = @(u) J * (u - truth);
%!   start = round (rand (5, 1));
%!   short(k) = norm (f (leastSquaresInBox (f, @(u, hook) J, start, settings)));
%! end
%! assert (sum (short > 0.02) <= 1);

%!test
%! % enough residuals: the plain solution, at the bound where that is outside
%! pkg load -nodeps struct optim
%! settings = optimset ('MaxIter', 60, 'TolFun', 1e-6);
%! f = @(u) [u(1) - 0.3; 2 * (u(2) - 1.5)];
%! u = leastSquaresInBox (f, @(u, hook) [1, 0; 0, 2], [0.5; 0.5], settings);
%! assert (u, [0.3; 1], 1e-6);

%!error <mine> leastSquaresInBox (@(u) error ('mine'), [], 0.5, struct ())
