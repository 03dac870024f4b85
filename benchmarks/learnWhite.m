% LEARNWHITE  Surrogates of all runs, whitened, and the noise that they hold.
%
% CALL: [PROBLEM, WHITE] = learnWhite (PROBLEM, DATA)
%
%   PROBLEM  struct of newGapProblem; of enterRuns
%   DATA     struct X, E, Z, replicate
%   WHITE    struct of whitenEmulator, and own (1 x T, variance of the noise
%            that the variances of predictGap hold) and ofRun (1 x T, that of a
%            single run)
%
% See also: markScore, markError

function [problem, white] = learnWhite (problem, data)
  options = gapOptions ([]);
  [problem, data] = enterRuns (problem, data, options);
  em = fitEmulator (problem, data, options);
  budget = noiseBudget (problem, em);
  at = problem.used;
  white = whitenEmulator (em, at, budget);
  white.own = sum ((white.W * budget.covariance(at, at)) .* white.W, 2)';
  white.ofRun = sum (white.W.^2 .* em.noiseVar(at), 2)';
end
