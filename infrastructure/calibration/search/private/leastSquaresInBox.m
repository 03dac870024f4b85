% LEASTSQUARESINBOX  Least squares of some residuals inside a box.
%
% CALL: [P, NITER] = leastSquaresInBox (F, J, P, BOX, SETTINGS)
%
%   F         handle r = f (p), p 1 x d, r a column
%   J         handle of its Jacobian by the parameters in the unit box
%   P         1 x d, the start; the solution, if need be moved (toAllowed)
%   BOX       struct limits (2 x d, see toUnit), allowed (see isAllowed)
%   SETTINGS  of optimset: MaxIter, TolFun
%   NITER     iterations; 0 where the start leaves no residual
%
% nonlin_residmin of optim. With fewer residuals than parameters its search for
% the active bounds (cpiv_bard) goes round in circles on rounding errors: it
% gives up ('not successful', 'pivot is zero') or stops where a step downhill
% inside the box is left. Then a pull to the start, 0.1 in residuals for a side
% of the box, makes the problem regular; a constant residual of 0.01 ends the
% search where only the pull is left to gain. The better of the two is taken.
%
% Errors: those of F and of nonlin_residmin

function [p, niter] = leastSquaresInBox (f, J, p, box, settings)
  u = min (max (toUnit (p, box.limits), 0), 1)';
  inBox = @(u) fromUnit (u', box.limits);
  r = @(u) f (inBox (u));
  niter = 0;
  if sumsq (r (u)) > eps (1)
    [u, niter] = solved (r, @(u, hook) J (inBox (u)), u, settings);
  end
  p = toAllowed (inBox (u), box);
end

function [u, niter] = solved (f, J, start, settings)
  d = numel (start);
  u = start;
  try
    [u, niter] = search (f, J, start, settings);
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
    [v, nPulled] = search (pulled, slope, start, settings);
    if sumsq (f (v)) <= sumsq (f (u))
      u = v;
      niter = nPulled;
    end
  end
end

function [u, niter] = search (f, J, u, settings)
  d = numel (u);
  settings = optimset (settings, 'dfdp', J, 'lbound', zeros (d, 1), ...
                       'ubound', ones (d, 1), 'user_interaction', ...
                       @(p, values, state) near (values, state));
  [u, ~, ~, info] = nonlin_residmin (f, u, settings);
  u = min (max (u, 0), 1);
  niter = info.niter;
end

% Residuals below 0.01 stay so far below a tolerance that no step is worth a call.
function [stop, info] = near (values, state)
  stop = strcmp (state, 'iter') && max (abs (values.residual)) < 0.01;
  info = '';
end

% Would a step down the steepest slope, safe for the linear model, gain 0.1 %?
function yes = leavesSlope (r, J, u)
  step = min (max (u - J' * r / sumsq (J(:)), 0), 1) - u;
  yes = sumsq (r + J * step) < 0.999 * sumsq (r);
end

%!shared settings, unit
%! settings = optimset ('MaxIter', 60, 'TolFun', 1e-6);
%! unit = @(d) struct ('limits', [zeros(1, d); ones(1, d)]);

%!test
%! % from a corner, two residuals of five parameters: 'not successful' in optim
%! J = [-2.653,  -2.439, 11.3,    0.008219,  0.8051; ...
%!       1.208,  11.02,  -4.094, -55.56,    -0.0003814];
%! start = [1, 1, 1, 0.7739, 0];
%! f = @(p) [-4.193; 7.254] + J * (p - start)';
%! [p, niter] = leastSquaresInBox (f, @(p) J, start, unit (5), settings);
%! assert (norm (f (p)) < 0.01 && niter > 0);
%! assert (all (p >= 0 & p <= 1));

%!test
%! % fewer residuals than parameters, residuals of 0 inside the box: alone,
%! % nonlin_residmin stops short of them in most of these
%! rand ('seed', 1);
%! randn ('seed', 1);
%! for k = 1:40
%!   J = randn (2, 5) .* exp (randn (2, 5));
%!   truth = rand (5, 1);
%!   f = @(p) J * (p' - truth);
%!   start = round (rand (5, 1))';
%!   short(k) = norm (f (leastSquaresInBox (f, @(p) J, start, unit (5), ...
%!                                          settings)));
%! end
%! assert (sum (short > 0.02) <= 1);

%!test
%! % enough residuals: the plain solution, at the bound where that is outside;
%! % none left at the start
%! f = @(p) [p(1) - 0.3; 2 * (p(2) - 1.5)];
%! box.limits = [0, 0; 2, 1];
%! J = @(p) [2, 0; 0, 2];
%! p = leastSquaresInBox (f, J, [0.5, 0.5], box, settings);
%! assert (p, [0.3, 1], 1e-6);
%! [p, niter] = leastSquaresInBox (@(p) p', J, [0, 0], box, settings);
%! assert ({p, niter}, {[0, 0], 0});
%!error <mine>
%! leastSquaresInBox (@(p) error ('mine'), [], 0.5, unit (1), struct ())

% SPDX-License-Identifier: GPL-3.0-only
