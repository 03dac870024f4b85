% PUBLISHEDMETHOD  The published algorithm on DEM, for comparison.
%
% CALL: PARAMS = publishedMethod (CASE, EVALUATE)
%
% CASE      see newCase
% EVALUATE  handle: n x d sets -> n x T results of DEM runs, NaN where a run
%           failed; its errors end the algorithm
% PARAMS    1 x d: the set that is handed back; empty where the algorithm ended
%           with an error
%
% Plan of Case.options.numOfSam rows; one Kriging model a target, affine trend,
% matern52; nonlin_residmin on them from the box centre; nonlin_residmin on the
% DEM with the central differences that are its default (0.1 % of a parameter,
% two runs each), at most Case.options.maxIter iterations, stopped by userInt as
% soon as one run meets the tolerances. A failed run ends it.
%
% See also: mwe, calibrateOnDEM

function params = publishedMethod (Case, evaluate)
  params = [];
  try
    params = calibrated (Case, evaluate);
  catch err
    printf ('published algorithm ended: %s\n', err.message);
  end
end

function params = calibrated (Case, evaluate)
  problem = newProblem (Case, []);
  plan = GenerateExperPlan (Case.limits, Case.options.numOfSam, Case.folder, ...
                            Case.options.seed);
  Z = evaluate (plan);
  whole = all (isfinite (Z), 2);
  options = struct ('trend', 'affine', 'covariance', 'matern52');
  for t = 1:columns (Z)
    surrogates(t) = fitSurrogate (plan(whole, :), Z(whole, t), ...
                                  Case.limits, options);
  end
  onKriging = @(p) problem.cost (p, @(p) evaluateKriging (p, surrogates));
  onDEM = @(p) problem.cost (p, @(p) oneRun (p, evaluate));
  limits = struct ('tolRes', problem.tol, 'maxIter', Case.options.maxIter);
  stop = @(p, vals, state) userInt (p, vals, state, true, limits);
  box = {'lbound', Case.limits(1, :)', 'ubound', Case.limits(2, :)'};
  first = nonlin_residmin (onKriging, mean (Case.limits)', ...
                           optimset (box{:}, 'MaxIter', 1000));
  settings = optimset (box{:}, 'MaxIter', Case.options.maxIter, 'TolFun', ...
                       Case.options.tolfun, 'user_interaction', stop);
  params = nonlin_residmin (onDEM, first, settings)';
end

function z = oneRun (p, evaluate)
  z = evaluate (p')';
  if any (isnan (z))
    error ('DEcalioc:publishedMethod:failedRun', 'a run failed');
  end
end

%!test
%! % stand-in of one result: the set meets it, and a failed run ends the search
%! Case = struct ('names', {{'a'}}, 'limits', [0; 1], 'folder', tempname ());
%! Case.targets = struct ('name', 'x', 'value', 1.6, 'tol', 0.01, 'model', 1);
%! Case.options = struct ('numOfSam', 6, 'seed', 1, 'maxIter', 3, ...
%!                        'tolfun', 1e-4, 'WRL', 0);
%! mkdir (Case.folder);
%! params = publishedMethod (Case, @(P) 1 + P);
%! none = publishedMethod (Case, @(P) (1 + P) ./ (rows (P) > 1) - 0 ./ ...
%!                                    (rows (P) > 1));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (Case.folder, 's');
%! assert (params, 0.6, 0.017);
%! assert (isempty (none));
