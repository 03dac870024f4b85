% NOISEBUDGET  Adds up what makes a result uncertain, cause by cause.
%
% CALL: BUDGET = noiseBudget (PROBLEM, EMULATOR)
%
%   PROBLEM     struct of newProblem
%   EMULATOR    struct of fitEmulator
%   BUDGET      struct
%     covariance  T x T, measurement plus the packing of the real trials; of a
%                 change also what the reference leaves open (emulateChange)
%     estimated   1 x T, part of its diagonal that was estimated from runs
%     unknown     1 x T, part of it whose size nobody has stated
%     doubt       2 x T, of what few trials and sessions tell: squares of its
%                 variances over their degrees of freedom (Satterthwaite 1946),
%                 of each target's own scatter and of what all have in common
%     own         1 x T, variance of the measurement without what sessions share
%     measurement, trial   1 x T, their standard deviations
%     noiseSd     1 x T, noise of one DEM run
%     surrogate   1 x T, root mean square over the box
%     share       1 x T, surrogate part of the whole variance (box average)
%
% One trial in the laboratory is one packing: its scatter is taken from the DEM
% seeds. The covariance of the means of n_i and n_j trials is that of one trial
% over sqrt (n_i n_j), n = PROBLEM.trials (Inf where sd already holds it).
% Where sd comes from the scatter of trials (PROBLEM.scatter) the larger of that
% part (without what sessions share) and the packings counts.

function budget = noiseBudget (problem, emulator)
  sd = problem.sd;
  sd(~isfinite (sd)) = 0;
  % a measurement without any error would leave no inverse
  least = (1e-4 * emulator.range).^2;
  measured = diag (sd.^2);
  if ~isempty (problem.covariance)
    measured = problem.covariance;
  end
  measured = measured + diag (max (least - diag (measured)', 0));
  own = max (diag (measured)' - problem.shared.^2, 0);
  % an sd that was taken from the scatter of trials holds their packing already
  trial = sqrt (max (emulator.noiseVar ./ problem.trials - ...
                     problem.scatter .* own, 0));
  budget.covariance = measured + (trial' * trial) .* emulator.correlation;
  budget.doubt = [(own + problem.shared.^2).^2 ./ problem.freedom; ...
                  own.^2 ./ problem.commonFreedom + ...
                  problem.shared.^4 ./ problem.sessionFreedom];
  if ~isempty (emulator.change)
    budget.covariance = emulator.change.covariance;
    budget.doubt = emulator.change.doubt;
  end
  % their degrees of freedom differ: from runs, or from nothing at all
  % (whitenEmulator)
  budget.estimated = trial.^2;
  budget.unknown = diag (measured)' .* ~problem.sdKnown;
  budget.own = own;
  budget.measurement = sqrt (diag (measured))';
  budget.trial = trial;
  budget.noiseSd = sqrt (emulator.noiseVar);
  known = mean (emulator.surrogateVar, 1) + emulator.fitVar;
  budget.surrogate = sqrt (known);
  budget.share = known ./ (known + diag (budget.covariance)');
end

%!test
%! problem = newProblem (struct ('value', [1, 2], 'sd', [3, 0], ...
%!                                     'limits', [0; 1], 'bench', [1, 1]));
%! emulator = struct ('noiseVar', [16, 4], 'correlation', [1, 0.5; 0.5, 1], ...
%!              'range', [1, 1], 'surrogateVar', [25, 8], 'fitVar', [0, 0], ...
%!              'change', []);
%! budget = noiseBudget (problem, emulator);
%! assert (budget.covariance, [25, 4; 4, 4], 1e-6);
%! assert (budget.share, [0.5, 2 / 3], 1e-6);
%! problem.covariance = [9, 3; 3, 4];
%! budget = noiseBudget (problem, emulator);
%! assert (budget.covariance, [25, 7; 7, 8], 1e-6);
%! assert (budget.measurement, [3, 2], 1e-6);
%! problem.covariance = [];
%! problem.trials = [4, 1];
%! assert (noiseBudget (problem, emulator).covariance, [13, 2; 2, 4], 1e-6);
%! problem.trials = [Inf, 1];
%! assert (noiseBudget (problem, emulator).covariance, [9, 0; 0, 4], 1e-6);
%! problem.trials = Inf;
%! assert (noiseBudget (problem, emulator).covariance(1, 1), 9, 1e-12);
%! problem.trials = [1, 4];
%! problem.scatter = [true, true];
%! assert (diag (noiseBudget (problem, emulator).covariance), [16; 1], 1e-6);
%! % what sessions share is none of the packings', and doubted by itself
%! problem.sd = [5, 0];
%! problem.shared = [4, 0];
%! [problem.commonFreedom, problem.sessionFreedom] = deal ([3, Inf], [2, Inf]);
%! problem.freedom = [5, Inf];
%! budget = noiseBudget (problem, emulator);
%! assert (budget.covariance(1, 1), 16 + 16, 1e-6);
%! assert (budget.doubt, [625 / 5, 0; 81 / 3 + 256 / 2, 0]);

% SPDX-License-Identifier: GPL-3.0-only
