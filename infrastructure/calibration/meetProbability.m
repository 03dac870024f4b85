% MEETPROBABILITY  Probability that a set truly meets all targets.
%
% CALL: [PROBABILITY, R, S] = meetProbability (SURROGATES, PROBLEM, P)
%
% SURROGATES   1 x T struct array of fitSurrogate
% PROBLEM      struct of newProblem
% P            n x d  parameter sets
% PROBABILITY  n x 1  product over the targets that are calibrated of
%                     Pr(|residual of the mean response| < tolerance); a curve
%                     is one of them (allMet)
% R, S         n x T  residual of the surrogate mean, its standard deviation
%
% PROBLEM.avoid (k x d, optional) holds sets at which runs failed again and
% again: the probability falls to 0 within a tenth of the box around them.
% Student's distribution with the degrees of freedom of the fit, because the
% noise is estimated from the same few runs.

function [probability, r, s] = meetProbability (surrogates, problem, P)
  [r, s] = residualSpread (surrogates, problem, P);
  probability = allMet (r, s, problem, [surrogates.df]);
  if isfield (problem, 'avoid')
    for i = 1:rows (problem.avoid)
      u = (P - problem.avoid(i, :)) ./ diff (problem.limits);
      probability = probability .* (1 - exp (-100 * sum (u.^2, 2)));
    end
  end
end

%!test
%! % far from the target 0, at the target of a sure surrogate 1
%! pkg load stk
%! rand ('twister', 1);
%! X = rand (12, 1);
%! C = struct ('names', {{'a'}}, 'limits', [0; 1], ...
%!             'targets', struct ('value', 1.5, 'tol', 0.05));
%! s = fitSurrogate (X, 1 + X, [0; 1]);
%! [p, r] = meetProbability (s, newProblem (C, []), [0.5; 0.1]);
%! assert (p, [1; 0], 0.02);
%! assert (r(2), -0.4 / 1.5, 0.01);
