% ESTIMATEMODEL  Parameters of a Kriging model by stk_param_estim.
%
% CALL: THETA = estimateModel (MODEL, U, Y [, START])
%
%   MODEL  struct of krigingModel
%   U, Y   n x d, n x 1, inputs in the unit box, standardised response
%   START  as THETA, where the search begins ([]: the means of the priors; of a
%          model without them what stk_param_init finds)
%   THETA  as that of fitCost
%
% stk's own tolerance, 1e-8, finds a cost that is lower by up to 0.02
% (benchmarks/krigingTime.m), or parameters that lie a fifth of their deviation
% away, in up to three times the time: here 0.01, but for a published model.
% Its warnings are about single steps of the search, and about a start that is the
% end.

function theta = estimateModel (model, U, y, start)
  if nargin < 4 || isempty (start)
    start = stk_get_optimizable_parameters (model);
  end
  heard = warning ();
  options = stk_options_get ();
  restore = onCleanup (@() restoreAll (heard, options));
  warning ('off', 'all');
  tuned = struct ('maxiter', 100, 'tol', 1e-2);
  if isfield (model, 'prior')
    search = stk_optim_octavesqp (tuned);
    stk_options_set ('stk_param_estim', 'minimize_box', search);
    stk_options_set ('stk_param_estim', 'minimize_unc', search);
  end
  n = numel (model.param);
  if any (isnan (start))
    [param, noise] = stk_param_init (model, U, y);
    start = [param(:); noise];
  end
  theta = start(:);
  try
    if hasBounds (model, U, y)
      [param, noise] = stk_param_estim (model, U, y, start(1:n), start(n + 1:end), ...
                                        model.criterion);
      theta(1:n) = param;
      theta(n + 1:end) = noise(1:numel (start) - n);
    else
      theta = leastCost (model, U, y, start(:), tuned);
    end
  catch
    % without a prior its line search may leave what a covariance can hold; the
    % start is taken if it has a cost
    fitCost (model, U, y, start(:));
  end
end

function yes = hasBounds (model, U, y)
  yes = ~isempty (stk_param_getdefaultbounds (model.covariance_type, model.param, U, y));
end

% As stk_param_estim does it where a covariance has no bounds, which stk 2.8 compares
% with bounds nevertheless, and finds nothing.
function theta = leastCost (model, U, y, start, tuned)
  cost = @(theta) fitCost (model, U, y, theta);
  slope = @(theta) nthargout (2, @fitCost, model, U, y, theta);
  [theta, least] = sqp (start, {cost, slope}, [], [], [], [], tuned.maxiter, tuned.tol);
  if ~(least < cost (start))
    theta = start;
  end
end

function restoreAll (heard, options)
  stk_options_set (options);
  warning (heard);
end

%!test
%! % no point beside it costs less; options and warnings stay as they were
%! pkg load stk
%! rand ('twister', 1);
%! U = rand (12, 2);
%! y = sin (3 * U(:, 1)) + U(:, 2);
%! of = struct ('noise', [], 'extra', [], 'prior', [], 'scatter', [], ...
%!              'scale', 1, 'quick', false, 'published', false);
%! model = krigingModel ('affine', 'matern52', 2, of);
%! before = {stk_options_get(), warning()};
%! theta = estimateModel (model, U, y);
%! assert (isequal ({stk_options_get(), warning()}, before));
%! [C, g] = fitCost (model, U, y, theta);
%! assert (norm (g) < 0.1);
%! again = estimateModel (model, U, y, theta);
%! assert (again, theta, 0.05);
%! % nor where the noise is one of the covariance
%! of.extra = U(:, 1);
%! model = krigingModel ('affine', 'matern52', 2, of);
%! [C, g] = fitCost (model, U, y, estimateModel (model, U, y));
%! assert (norm (g) < 0.1);
%!function varargout = atStartAlone (start, model, varargin)
%!  assert (model.param(:), start(1:numel (model.param)));
%!  [varargout{1:nargout}] = stk_param_relik (model, varargin{:});
%!endfunction
%!test
%! % a search that ends in an error, as of a covariance of NaN, leaves the start
%! pkg load stk
%! rand ('twister', 1);
%! U = rand (12, 2);
%! of = struct ('noise', [], 'extra', [], 'prior', [], 'scatter', [], ...
%!              'scale', 1, 'quick', false, 'published', true);
%! model = krigingModel ('affine', 'matern', 2, of);
%! start = [0; 0.5; 0; 0; -4];
%! model.criterion = @(varargin) atStartAlone (start, varargin{:});
%! assert (estimateModel (model, U, U * [1; 2], start), start);

% SPDX-License-Identifier: GPL-3.0-only
