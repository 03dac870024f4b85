% DESCRIBESET  What the surrogates say about one parameter set.
%
% CALL: found = describeSet (surrogates, problem, p)
%
% p      1 x d
% found  struct: params, result 1 x T, sd 1 x T (of the mean response),
%        residual (T + extra) x 1, residualSd T x 1, probability, within
%
% See also: calibrateOnKriging, meetProbability

function found = describeSet (surrogates, problem, p)
  [m, v] = predictSurrogate (surrogates, p);
  [probability, r, s] = meetProbability (surrogates, problem, p);
  use = problem.calibrate;
  full = problem.cost (p(:), @(varargin) m(:));
  found = struct ('params', p, 'result', m, 'sd', sqrt (v), ...
                  'residual', full(:), 'residualSd', s', ...
                  'probability', probability, ...
                  'within', all (abs (r(use)) <= problem.tol(use)));
end
