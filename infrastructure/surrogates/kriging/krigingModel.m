% KRIGINGMODEL  The stk model of a response, with what is known of it beforehand.
%
% CALL: MODEL = krigingModel (TREND, COVARIANCE, D)
% CALL: MODEL = krigingModel (TREND, COVARIANCE, D, OF)
%
%   TREND       'constant', 'affine', 'quadratic', or a known shape, see trendOf
%   COVARIANCE  'matern52', 'matern32', 'gauss', 'matern', 'exp', 'sph':
%               stk_materncov52_aniso and so on; 'matern52_iso' and the like:
%               stk_materncov52_iso
%   D           number of inputs, of the unit box
%   OF          struct, makes a model to be fitted: noise (n x 1 known variances
%               of the standardised response, or []: estimated), extra (n x 1 or
%               []: given, the logarithm of the estimated noise is affine in the
%               last input), prior ((D + 2) x 1, parameters of a similar bench,
%               known to a factor of 1.6; NaN: not known; []: none), scatter and
%               scale (see noisePrior), quick and published (logical: see
%               fitSurrogate)
%   MODEL       struct of stk; with OF its param and lognoisevariance are the
%               means of prior and noiseprior, both normal: the part beyond the
%               trend, ranges and noise of a usual DEM response; criterion is a
%               handle of its likelihood, stk_param_relik or quickCost; NaN and
%               no prior in a published one
%
% The priors cost nothing where the runs speak; without them few runs per
% parameter let the noise collapse to zero. stk_param_relik reads both.
%
% A noise that follows the last input is no noise to stk, which knows one number
% or none that is estimated: it is a part of the covariance then (noisyCovariance).

function model = krigingModel (trend, covariance, d, of)
  kernel = ['stk_', regexprep(covariance, '^(matern|gauss|exp|sph)', '$1cov')];
  if isempty (strfind (kernel, '_iso'))
    kernel = [kernel, '_aniso'];
  end
  model = stk_model (kernel, d);
  model.lm = trendOf (trend);
  if nargin > 3 && of.published
    model.lognoisevariance = NaN;              % to be estimated
    model.criterion = @stk_param_relik;
  elseif nargin > 3
    model = withPriors (model, of, trend);
  end
end

function model = withPriors (model, of, trend)
  d = model.dim;
  [ofNoise, open] = noisePrior (of.scatter, of.scale);
  [beyond, ofBeyond] = beyondTrend (trend);
  mean = [log(beyond); -log(1.5) * ones(d, 1); ofNoise];
  sd = [ofBeyond; ones(d, 1); open];
  if ~isempty (of.prior)
    known = isfinite (of.prior);
    variance = 1 ./ (1 ./ sd(known).^2 + 1 / 0.5^2);
    mean(known) = variance .* (mean(known) ./ sd(known).^2 + ...
                               of.prior(known) / 0.5^2);
    sd(known) = sqrt (variance);
  end
  count = d + 1;
  model.criterion = @stk_param_relik;
  if of.quick && isempty (of.extra)
    model.criterion = @quickCost;
  end
  if ~isempty (of.noise)
    model.lognoisevariance = log (of.noise);
  elseif ~isempty (of.extra)
    kernel = model.covariance_type;
    model.covariance_type = @(varargin) noisyCovariance (kernel, varargin{:});
    mean(end + 1) = 0;
    sd(end + 1) = 1.5;
    count = d + 3;
  else
    model.lognoisevariance = mean(end);
    model.noiseprior = normal (mean(end), sd(end));
  end
  model.param = mean(1:count);
  model.prior = normal (mean(1:count), sd(1:count));
end

% Share of the variance of a response that is beyond the trend, and the sd of its
% logarithm. A shape is that of another material or rig: it is never as near as the
% few runs at the start may look.
function [share, sd] = beyondTrend (trend)
  [share, sd] = deal (0.01, 2);
  if strcmp (trend, 'constant')
    share = 1;
  elseif ~ischar (trend)
    [share, sd] = deal (0.05, 1.5);
  end
end

function distribution = normal (mean, sd)
  distribution = struct ('mean', mean, 'sd', sd, 'invcov', diag (1 ./ sd.^2));
end

%!shared usual
%! pkg load stk
%! usual = struct ('noise', [], 'extra', [], 'prior', [], 'scatter', [], ...
%!                 'scale', 1, 'quick', false, 'published', false);

%!test
%! % what is known of a similar bench draws the prior to it
%! model = krigingModel ('affine', 'gauss', 1, usual);
%! assert (model.param, [log(0.01); -log(1.5)], 1e-12);
%! assert (model.lognoisevariance, 2 * log (0.3), 1e-12);
%! usual.prior = [NaN; 1; NaN];
%! drawn = krigingModel ('affine', 'gauss', 1, usual);
%! assert (drawn.prior.sd, [2; 1 / sqrt(5)], 1e-12);
%! assert (drawn.param(2), (4 - log (1.5)) / 5, 1e-12);

%!test
%! % known noises have no prior, a noise along the last input two parameters
%! known = setfield (usual, 'noise', [1; 2]);
%! model = krigingModel ('constant', 'matern32', 2, known);
%! assert ({numel(model.param), isfield(model, 'noiseprior')}, {3, false});
%! model = krigingModel ('constant', 'matern32', 2, ...
%!                       setfield (usual, 'extra', [0; 1]));
%! assert (numel (model.param), 5);

% SPDX-License-Identifier: GPL-3.0-only
