% PUBLISHEDMETHOD  The published algorithm on DEM, for comparison.
%
% CALL: PARAMS = publishedMethod (CASE, ISSPENT)
%
% CASE     see newCase
% ISSPENT  handle without arguments: true when no further run may be started
% PARAMS   1 x d: the set that is handed back; empty where the algorithm was
%          stopped or ended with an error
%
% Plan of Case.options.numOfSam rows; one Kriging model a target, affine trend,
% matern52; nonlin_residmin on them from the box centre; nonlin_residmin on the
% DEM with its own forward differences (0.1 % of a parameter), at most
% Case.options.maxIter iterations, stopped by userInt as soon as one run meets
% the tolerances. A failed run ends it.
%
% See also: mwe, publishedStage

function params = publishedMethod (Case, isSpent)
  params = [];
  try
    params = calibrated (Case, isSpent);
  catch problemFound
    printf ('published algorithm ended: %s\n', problemFound.message);
  end
end

function params = calibrated (Case, isSpent)
  problem = newProblem (Case, []);
  plan = GenerateExperPlan (Case.limits, Case.options.numOfSam, Case.folder, ...
                            Case.options.seed);
  Z = runOnce (plan, Case, isSpent);
  whole = all (isfinite (Z), 2);
  options = struct ('trend', 'affine', 'covariance', 'matern52');
  for t = 1:columns (Z)
    surrogates(t) = fitSurrogate (plan(whole, :), Z(whole, t), ...
                                  Case.limits, options);
  end
  onKriging = @(p) problem.cost (p, @(p) evaluateKriging (p, surrogates));
  onDEM = @(p) problem.cost (p, @(p) runOnce (p', Case, isSpent)');
  limits = struct ('tolRes', problem.tol, 'maxIter', Case.options.maxIter);
  stop = @(p, vals, state) userInt (p, vals, state, true, limits);
  box = {'lbound', Case.limits(1, :)', 'ubound', Case.limits(2, :)'};
  first = nonlin_residmin (onKriging, mean (Case.limits)', ...
                           optimset (box{:}, 'MaxIter', 1000));
  settings = optimset (box{:}, 'MaxIter', Case.options.maxIter, 'TolFun', ...
                       Case.options.tolfun, 'user_interaction', stop);
  params = nonlin_residmin (onDEM, first, settings)';
end

function Z = runOnce (P, Case, isSpent)
  Z = zeros (rows (P), numel (Case.targets));
  batch = Case.options.maxCPU;
  for first = 1:batch:rows (P)
    if isSpent ()
      error ('DEcalioc:publishedMethod:spent', 'the limit is reached');
    end
    at = first:min (first + batch - 1, rows (P));
    Z(at, :) = evaluateDEM (P(at, :), Case, ones (numel (at), 1), ...
                            'published', @(varargin) []);
  end
  if rows (P) == 1 && any (isnan (Z))
    error ('DEcalioc:publishedMethod:failedRun', 'a run failed');
  end
end

%!test
%! % a stand-in for evaluateDEM is not needed: a spent limit stops it at once
%! Case = struct ('names', {{'a'}}, 'limits', [0; 1], 'folder', tempname ());
%! Case.targets = struct ('name', 'x', 'value', 1, 'tol', 0.01, 'model', 1);
%! Case.options = struct ('numOfSam', 3, 'seed', 1, 'maxCPU', 1);
%! root = fileparts (fileparts (which ('startToolbox')));
%! addpath (fullfile (root, 'benchmarks'));
%! startToolbox (root);
%! mkdir (Case.folder);
%! params = publishedMethod (Case, @() true);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (Case.folder, 's');
%! assert (isempty (params));
