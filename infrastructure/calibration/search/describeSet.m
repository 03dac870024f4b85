% DESCRIBESET  What the surrogates say about one parameter set.
%
% CALL: FOUND = describeSet (SURROGATES, PROBLEM, P)
%
% P      1 x d; it is rounded as its runs will be (toDigits)
% FOUND  struct: params, residual (T + extra) x 1, probability, within

function found = describeSet (surrogates, problem, p)
  p = toDigits (p);
  m = predictSurrogate (surrogates, p);
  full = problem.cost (p(:), @(varargin) m(:));
  [probability, share] = meetProbability (surrogates, problem, p);
  found = struct ('params', p, 'residual', full(:), ...
                  'probability', probability, 'within', all (share <= 1));
end

%!test
%! [problem, state, s] = smallCalibration ();
%! found = describeSet (s, problem, [0.5, 1]);
%! assert (found.residual, [4; 1.9] ./ [4; 2] - 1, 0.01);
%! assert (found.residual, residualSpread (s, problem, [0.5, 1])', 1e-12);
%! assert (size (found.probability), [1, 1]);

% SPDX-License-Identifier: GPL-3.0-only
