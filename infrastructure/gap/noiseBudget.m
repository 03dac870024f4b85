% NOISEBUDGET  Adds up what makes a result uncertain, cause by cause.
%
% CALL: BUDGET = noiseBudget (PROBLEM, EM)
%
%   PROBLEM  struct of newGapProblem
%   EM       struct of fitEmulator
%   BUDGET   struct
%     covariance  T x T, measurement plus the packing of the real trials
%     measurement, trial   1 x T, their standard deviations
%     seed        1 x T, scatter of one DEM run
%     surrogate   1 x T, root mean square over the box
%     share       1 x T, surrogate part of the whole variance (box average)
%
% One trial in the laboratory is one packing: its scatter is taken from the DEM
% seeds and divided by PROBLEM.trials (Inf where sd already holds it).
%
% See also: whitenEmulator, locateGap

function budget = noiseBudget (problem, em)
  sd = problem.sd;
  sd(~isfinite (sd)) = 0;
  measured = diag (max (sd, 1e-4 * em.range).^2);
  if ~isempty (problem.covariance)
    measured = problem.covariance;
  end
  trial = sqrt (em.seedVar / problem.trials);
  budget.covariance = measured + (trial' * trial) .* em.correlation;
  budget.measurement = sqrt (diag (measured))';
  budget.trial = trial;
  budget.seed = sqrt (em.seedVar);
  known = mean (em.surrogateVar, 1) + em.fitVar;
  budget.surrogate = sqrt (known);
  budget.share = known ./ (known + diag (budget.covariance)');
end

%!test
%! problem = newGapProblem (struct ('y', [1, 2], 'sd', [3, 0], ...
%!                                  'limits', [0; 1], 'bench', [1, 1]));
%! em = struct ('seedVar', [16, 4], 'correlation', [1, 0.5; 0.5, 1], ...
%!              'range', [1, 1], 'surrogateVar', [25, 8], 'fitVar', [0, 0]);
%! budget = noiseBudget (problem, em);
%! assert (budget.covariance, [25, 4; 4, 4], 1e-6);
%! assert (budget.share, [0.5, 2 / 3], 1e-6);
%! problem.trials = Inf;
%! assert (noiseBudget (problem, em).covariance(1, 1), 9, 1e-12);
