% DESCRIBESET  What the surrogates say about one parameter set.
%
% CALL: FOUND = describeSet (SURROGATES, PROBLEM, P)
%
% P      1 x d
% FOUND  struct: params, result 1 x T, sd 1 x T (of the mean response),
%        residual (T + extra) x 1, residualSd T x 1, probability, within

function found = describeSet (surrogates, problem, p)
  [m, v] = predictSurrogate (surrogates, p);
  [probability, r, s] = meetProbability (surrogates, problem, p);
  full = problem.cost (p(:), @(q, varargin) evaluateKriging (q, surrogates));
  found = struct ('params', p, 'result', m, 'sd', sqrt (v), ...
                  'residual', full(:), 'residualSd', s', ...
                  'probability', probability, ...
                  'within', all (toleranceShare (problem, r) <= 1));
end

%!shared problem, state, s
%! [problem, state, s] = smallCalibration ();

%!test
%! found = describeSet (s, problem, [0.5, 1]);
%! assert (found.result, [4, 1.9], 0.04);
%! assert (found.residual, found.result' ./ [4; 2] - 1, 1e-12);
%! assert (found.residualSd, found.sd' ./ [4; 2], 1e-12);
%! assert (size (found.probability), [1, 1]);
