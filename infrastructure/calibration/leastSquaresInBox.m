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
% nonlin_residmin of optim. From a corner of the box, with fewer residuals than
% parameters, its search for the active bounds (cpiv_bard) can go round in
% circles on rounding errors; it gives up with 'not successful'. Then a pull of
% 1e-4 to the start, in residuals for a side of the box, makes the problem
% regular; a constant residual of 0.01 ends the search where only the pull is
% left to gain.
%
% Errors: those of F and of nonlin_residmin
%
% See also: solveStart, mostProbableSet

function [u, cvg, niter] = leastSquaresInBox (f, J, u, settings)
  d = numel (u);
  settings = optimset (settings, 'lbound', zeros (d, 1), ...
                       'ubound', ones (d, 1), 'dfdp', J);
  start = u;
  try
    [u, ~, cvg, info] = nonlin_residmin (f, start, settings);
  catch err
    if ~strcmp (err.message, 'not successful')
      rethrow (err);
    end
    pull = [1e-4 * eye(d); zeros(1, d)];
    settings = optimset (settings, 'dfdp', @(u, hook) [J(u, hook); pull]);
    pulled = @(u) [f(u); pull * (u - start) + [zeros(d, 1); 0.01]];
    [u, ~, cvg, info] = nonlin_residmin (pulled, start, settings);
  end
  u = min (max (u, 0), 1);
  niter = info.niter;
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
%! assert (norm (f (u)) < 1e-3 && niter > 0);
%! assert (all (u >= 0 & u <= 1));

%!test
%! % enough residuals: the plain solution, at the bound where that is outside
%! pkg load -nodeps struct optim
%! settings = optimset ('MaxIter', 60, 'TolFun', 1e-6);
%! f = @(u) [u(1) - 0.3; 2 * (u(2) - 1.5)];
%! u = leastSquaresInBox (f, @(u, hook) [1, 0; 0, 2], [0.5; 0.5], settings);
%! assert (u, [0.3; 1], 1e-6);

%!error <mine> leastSquaresInBox (@(u) error ('mine'), [], 0.5, struct ())
