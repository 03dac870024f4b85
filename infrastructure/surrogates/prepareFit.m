% PREPAREFIT  Everything of a fit that does not depend on the parameters.
%
% CALL: FIT = prepareFit (U, Y, TREND, KERNEL, NOISE)
% CALL: FIT = prepareFit (U, Y, TREND, KERNEL, [], LEVEL)
%
% U       n x d  inputs in the unit box; Y  n x 1 standardised response
% TREND   'constant', 'affine' or 'quadratic'; KERNEL  see correlationOf
% NOISE   n x 1 known variances, or [] (estimated)
% LEVEL   n x 1, how coarse a run is (0: as fine as the runs that count); the
%         logarithm of the estimated noise is affine in it
% FIT     struct of penalisedLikelihood, with the prior (mean, sd): the part
%         beyond the trend, the ranges and the noise of a usual DEM response
%
% See also: penalisedLikelihood, fitSurrogate

function fit = prepareFit (U, y, trend, kernel, noise, level)
  [n, d] = size (U);
  S = zeros (n * n, d);
  for j = 1:d
    S(:, j) = reshape ((U(:, j) - U(:, j)').^2, [], 1);
  end
  H = feval (feval (['stk_lm_' trend]), U);
  [Q, ~] = qr (H);
  fit.S = S;
  fit.W = Q(:, columns (H) + 1:end);
  fit.y = y;
  fit.kernel = kernel;
  fit.noise = noise;
  fit.level = [];
  beyond = 0.01;
  if strcmp (trend, 'constant')
    beyond = 1;
  end
  fit.mean = [log(beyond); -log(1.5) * ones(d, 1); 2 * log(0.1)];
  fit.sd = [2; ones(d, 1); 1.2];
  if ~isempty (noise)
    fit.mean(end) = [];
    fit.sd(end) = [];
  elseif nargin > 5 && ~isempty (level)
    fit.level = level;
    fit.mean(end + 1) = 0;
    fit.sd(end + 1) = 1.5;
  end
end

%!test
%! pkg load stk
%! U = [0; 0.5; 1];
%! fit = prepareFit (U, [1; 2; 4], 'affine', 'gauss', []);
%! assert (fit.S, reshape ((U - U') .^ 2, 9, 1));
%! assert (fit.W' * [ones(3, 1), U], [0, 0], 1e-12);
%! assert (size (fit.W), [3, 1]);
