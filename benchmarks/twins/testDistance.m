% TESTDISTANCE  How far the truth is from the nearest rival cause.
%
% CALL: D = testDistance (MEANS, TWIN, SD)
%
%   MEANS  handle, M = MEANS (THETA, PHI), results without noise
%   TWIN   struct of testCase;  SD  1 x T, whole noise of each result
%   D      distance in standard deviations, smallest over the other single
%          effects with parameters in the box and strengths in [-1, 1] of their
%          own (nonlin_residmin from three points)
%
% See also: testCeiling

function d = testDistance (means, twin, sd)
  truth = means (twin.theta, twin.phi) ./ sd;
  p = numel (twin.theta);
  d = Inf;
  for k = setdiff (1:numel (twin.phi), twin.cause)
    unit = zeros (1, numel (twin.phi));
    unit(k) = 1;
    miss = @(q) (means (q(1:p)', q(p + 1) * unit) ./ sd - truth)';
    for phi = [0.3, 0.8, -0.3]
      d = min (d, norm (miss (nearest (miss, [twin.theta, phi]'))));
    end
  end
end

function q = nearest (miss, q)
  lower = [zeros(numel (q) - 1, 1); -1];
  settings = optimset ('lbound', lower, 'ubound', ones (size (q)), ...
                       'MaxIter', 40, 'TolFun', 1e-6, 'user_interaction', {});
  settings = optimset (settings, 'dfdp', @(q) slopes (miss, q, lower));
  q = nonlin_residmin (miss, q, settings);
end

function J = slopes (miss, q, lower)
  J = zeros (numel (miss (q)), numel (q));
  for j = 1:numel (q)
    step = zeros (size (q));
    step(j) = 1e-4 * (1 - 2 * (q(j) > 0.5));
    J(:, j) = (miss (q + step) - miss (q)) / step(j);
  end
end

%!test % two effects, one parameter: what the rival cannot do is left
%! pkg load optim
%! means = @(theta, phi) theta * [1, 0, 0] + phi * [0, 1, 0; 0, 1, 1];
%! twin = struct ('theta', 0.5, 'phi', [0.4, 0], 'cause', 1);
%! assert (testDistance (means, twin, [0.1, 0.1, 0.1]), ...
%!         4 / sqrt (2), 1e-3);
