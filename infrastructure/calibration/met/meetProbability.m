% MEETPROBABILITY  Probability that a set truly meets all targets.
%
% CALL: [PROBABILITY, SHARE, R] = meetProbability (SURROGATES, PROBLEM, P)
%
% P            n x d  parameter sets
% PROBABILITY  n x 1  see allMet; Student's distribution with the degrees of
%                     freedom of the fit, because the noise is estimated from
%                     the same few runs
% SHARE        n x G  of the surrogate mean, see toleranceShare
% R            n x T  residual of the surrogate mean
%
% PROBLEM.avoid, PROBLEM.odd: see mixtureMet.

function [probability, share, r] = meetProbability (surrogates, problem, P)
  [r, s] = residualSpread (surrogates, problem, P);
  probability = mixtureMet (r, s, problem, [surrogates.df], P);
  if nargout > 1
    share = toleranceShare (problem, r);
  end
end

%!test
%! % far from the target 0, at the target of a sure surrogate 1; 0 where runs
%! % failed
%! rand ('twister', 1);
%! X = rand (12, 1);
%! problem = smallProblem (1.5, 0.05);
%! s = fitSurrogate (X, 1 + X, [0; 1]);
%! [p, share, r] = meetProbability (s, problem, [0.5; 0.1]);
%! assert (p, [1; 0], 0.02);
%! assert (r(2), -0.4 / 1.5, 0.01);
%! assert (share, abs (r) / 0.05, 1e-12);
%! problem.avoid = 0.5;
%! assert (meetProbability (s, problem, 0.5), 0);

% SPDX-License-Identifier: GPL-3.0-only
