% TWINSSPACE  What parameters cannot hide: noise and slopes at one point.
%
% CALL: SPACE = twinsSpace (LAB, THETA)
%
%   LAB    struct with means, noise (1 x T, standard deviations of the whole
%          noise) and problem
%   THETA  1 x p, in [0, 1]
%   SPACE  struct: theta, base (1 x T, results without an effect), factor (T x
%          T, FACTOR * FACTOR' is the covariance), free (T x m, what the
%          whitened slopes of the parameters leave), visible (handle, D =
%          visible (SHAPE): signal to noise of the rows of SHAPE)
%
% See also: twinsDraw, twinsStrength

function space = twinsSpace (lab, theta)
  p = numel (theta);
  none = zeros (p, numel (lab.problem.effects));
  step = 0.02 * full (eye (p));
  slopes = (lab.means (theta + step, none) - ...
            lab.means (theta - step, none))' / 0.04;
  factor = diag (lab.noise);
  free = null ((factor \ slopes)');
  space = struct ('theta', theta, 'factor', factor, 'free', free, ...
                  'base', lab.means (theta, none(1, :)));
  space.visible = @(shape) norm (free' * (factor \ shape'), 'columns')';
end

%!test % one parameter moves the first of two results: the second is left
%! lab.means = @(theta, phi) theta * [5, 0] + phi * [3, 4];
%! lab.noise = [1, 2];
%! lab.problem.effects = 1;
%! space = twinsSpace (lab, 0.3);
%! assert (space.visible ([7, 4; 7, -6]), [2; 3], 1e-12);
%! assert (space.base, [1.5, 0], 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
