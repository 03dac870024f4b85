% DEVIATIONOF  Tells how far a fitted model is off, and what noise makes of it.
%
% CALL: D = deviationOf (STUDY, SET, DRAWS)
%
%   STUDY   struct problem, emulator, hypotheses
%   SET    struct of runCures: h, Q, Z, verified
%   DRAWS  struct noise, surrogate, prior, run: B x n, B x n, B x p, B x n,
%          standard normal numbers; n used targets, then the held-out ones
%   D      struct
%     r      1 x n, measured values less the mean of the runs
%     F      n x n, covariance of r where the model with its effects is right
%     E      B x n, draws of it
%     Sigma  n x n, what the fit took for the noise of each target
%     J      n x q, slopes along the unknowns that the fit was free to move
%     s      1 x n, what the effects add
%     scatter  1 x n, variance of the mean of the runs (0: not run)
%     nu     scalar, degrees of freedom of Sigma
%
% The fit has bent to the noise: with K what it moves by an error of the used
% targets, r = (1 - K) noise + K error of the surrogate - scatter of the runs.
% The trace of F in units of Sigma is n - q where surrogates are exact: these
% are the freedoms that the fit took. An unknown at its limit took none. Without
% runs the surrogate is what r is taken from, and its error a part of the noise.
% The scatter of the runs is their own, and the pooled one as of four runs more.

function d = deviationOf (study, set, draws)
  problem = study.problem;
  emulator = study.emulator;
  targets = [problem.used, problem.heldOut];
  used = 1:numel (problem.used);
  budget = noiseBudget (problem, emulator);
  white = whitenEmulator (emulator, targets, budget);
  [M, V, S, J] = predictGap (white, set.h, set.Q);
  isTarget = white.isTarget > 0;
  back = [inv(white.W(isTarget, :)), zeros(numel (targets), sum (~isTarget))];
  d.Sigma = back * diag (V) * back';
  d.s = S * back';
  % the harmonic mean: what is known least decides
  d.nu = 1 / (mean (1 ./ white.nu) + 1 / white.common.freedom);
  J = reshape (vertcat (J{:})', columns (white.coef), numel (set.Q));
  % an unknown at its limit could not bend to the noise
  free = isFree (white, set, study.hypotheses.options.limitAt);
  d.J = back * J(:, free);
  known = diag ([study.hypotheses.prior.sd, Inf(1, numel (set.h))].^-2);
  told = J(~isTarget, :);
  known = known(free, free) + told(:, free)' * told(:, free);
  knownRoot = sqrt (known);
  if ~isempty (told)
    knownRoot = covarianceRoot (known);
  end
  weighted = d.J(used, :)' / d.Sigma(used, used);
  % an unknown that no used target sees stays where it is
  C = pinv (weighted * d.J(used, :) + known);
  K = zeros (numel (targets));
  % hat matrix of the fit: what it moves by an error of a used target
  K(:, used) = d.J * C * weighted;
  noise = budget.covariance(targets, targets);
  surrogate = d.Sigma - noise;
  run = zeros (numel (targets));
  d.r = problem.value(targets) - M * back';
  if set.verified
    d.r = problem.value(targets) - mean (set.Z(:, targets), 1);
    % runs replace the surrogate, so its error is in the place of the fit alone
    run = ofRuns (emulator, set.Z, targets);
  else
    noise = d.Sigma;
    surrogate(:) = 0;
  end
  d.scatter = diag (run)';
  roots = {(eye (numel (targets)) - K) * covarianceRoot(noise), ...
           K * covarianceRoot(surrogate), d.J * C * knownRoot, covarianceRoot(run)};
  d.F = zeros (numel (targets));
  for root = roots
    d.F = d.F + root{1} * root{1}';
  end
  d.E = draws.noise * roots{1}' + draws.surrogate * roots{2}' + ...
        draws.prior(:, 1:sum (free)) * roots{3}' + draws.run * roots{4}';
end

function free = isFree (white, set, limitAt)
  p = white.p;
  free = abs (set.Q(1:p)) < limitAt;
  for i = 1:numel (set.h)
    range = white.effect(set.h(i)).range;
    margin = (1 - limitAt) * diff (range);
    free(p + i) = set.Q(p + i) > range(1) + margin && ...
                  set.Q(p + i) < range(2) - margin;
  end
end

% Covariance of the mean of the runs Z.
function C = ofRuns (emulator, Z, targets)
  n = rows (Z);
  squares = (n - 1) * var (Z(:, targets), 0, 1);
  % what the emulator knows of the noise counts as four degrees of freedom more
  sd = sqrt ((squares + 4 * emulator.noiseVar(targets)) / (n + 3) / n);
  C = (sd' * sd) .* emulator.correlation(targets, targets);
end

%!shared study, draws
%! problem = newProblem (struct ('value', [1, 2, 3, 4], ...
%!                             'sd', [1, 1, 1, 1], 'trials', Inf, ...
%!                             'bench', [1, 1, 1, 2], 'limits', [-1; 1]));
%! emulator = handMadeEmulator ([0, 0, 0, 0; 3, 1, 0, 2]);
%! emulator.noiseVar = 0.5 * emulator.noiseVar;
%! study = struct ('problem', problem, 'emulator', emulator);
%! study.hypotheses.prior = struct ('mean', 0, 'sd', Inf);
%! study.hypotheses.options = gapOptions ([]);
%! randn ('twister', 3);
%! draws = struct ('noise', randn (4000, 4), 'surrogate', randn (4000, 4), ...
%!                 'prior', randn (4000, 1), 'run', randn (4000, 4));
%!test
%! % one freedom is taken: the trace is 3, the parity direction keeps its noise
%! set = struct ('h', zeros (1, 0), 'Q', 0.5, 'Z', [], 'verified', false);
%! d = deviationOf (study, set, draws);
%! assert (d.r, [1, 2, 3, 4] - [1.5, 0.5, 0, 1], 1e-9);
%! assert (trace (d.F / d.Sigma), 3, 1e-9);
%! assert (cov (d.E), d.F, 0.1);
%! % at its limit the parameter takes none
%! set.Q = 1;
%! assert (trace (deviationOf (study, set, draws).F), 4, 1e-6);
%! % runs have a scatter, four of them here with the pooled one
%! set.Z = repmat ([3, 1, 0, 2], 4, 1);
%! set.verified = true;
%! d = deviationOf (study, set, draws);
%! assert (diag (d.F)', 1 + 0.5 * 4 / 7 / 4 * ones (1, 4), 1e-6);
%!test
%! % a target that was not fitted bears the error of the parameter
%! held = study;
%! held.problem.used = 1:3;
%! held.problem.heldOut = 4;
%! set = struct ('h', zeros (1, 0), 'Q', 0.5, 'Z', [], 'verified', false);
%! d = deviationOf (held, set, draws);
%! assert (d.F(4, 4), 1 + 4 / 10, 1e-9);

% SPDX-License-Identifier: GPL-3.0-only
