% REQUIREMENTPROBABILITY  Probability that one requirement is truly met.
%
% CALL: P = requirementProbability (R, S, OWN, PROBLEM, DF)
%
% R, S     n x T  residuals of the mean response, their standard deviations
% OWN      target numbers of the requirement, see requirementsOf
% PROBLEM  struct of newProblem
% DF       1 x T  degrees of freedom of the noise estimates
% P        n x 1
%
% See also: meetProbability, confirmSet

function p = requirementProbability (r, s, own, problem, df)
  if isscalar (own)
    p = insideProbability (r(:, own), s(:, own), problem.tol(own), df(own));
  else
    tol = problem.tol(own);
    p = curveProbability (r(:, own) ./ tol, s(:, own) ./ tol, min (df(own)));
  end
end

%!test
%! problem.tol = [0.1, 0.2, 0.2];
%! r = [0.05, 0.1, 0.1];
%! s = [0.05, 0.1, 0.1];
%! p = insideProbability (0.5, 0.5, 1, 9);
%! assert (requirementProbability (r, s, 1, problem, [9, 9, 9]), p, 1e-10);
%! assert (requirementProbability (r, s, 2:3, problem, [5, 9, 11]), p, 1e-10);
