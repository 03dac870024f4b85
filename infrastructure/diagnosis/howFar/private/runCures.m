% RUNCURES  Refits the model without and with effects, and runs both.
%
% CALL: [SETS, STATE] = runCures (STUDY, CAUSES, STATE, SETS)
%
%   STUDY    struct problem, emulator, hypotheses, fits: of newProblem, fitEmulator,
%            makeHypotheses, fitLibrary (first row: the measured values)
%   CAUSES   1 x m cell of effect numbers in HYPOTHESES, refitted alike on the used
%            targets only
%   STATE    of newGapState
%   SETS     given: what has been compared before; CAUSES are added to it. Got:
%            1 x (m + 1) struct h (effects; [] first: the calibrated model), Q
%            (fitted parameters and strengths), Z (repeats x T), worstZ (largest
%            deviation of the DEM mean from the surrogate in standard
%            deviations; NaN: not run), verified (logical: Z is of DEM)
%
% With fewer runs left, fewer seeds; with less than two seeds a set surrogates
% stand in for DEM.

function [sets, state] = runCures (study, causes, state, sets)
  blank = struct ('h', zeros (1, 0), 'Q', study.fits.calibrated.Q(1, :), ...
                  'Z', [], 'worstZ', NaN, 'verified', false);
  known = 0;
  if nargin > 3
    known = numel (sets);
  else
    sets = blank;
  end
  for h = causes
    blank.h = h{1};
    blank.Q = fitCure (study, h{1});
    sets(end + 1) = blank;
  end
  new = known + 1:numel (sets);
  % two seeds each at least, as one tells no scatter
  verify = ~isempty (state.evaluate) && state.budget.sets >= 2 * numel (new);
  if verify
    state.repeats = min (state.repeats, floor (state.budget.sets / numel (new)));
  end
  for i = new
    if verify
      [sets(i), state] = runSet (study, sets(i), state);
    end
    if rows (sets(i).Z) < 2
      sets(i).Z = [];
      sets(i).verified = false;
    end
  end
end

% Effects of the laboratory act on the results of a neutral run.
function [set, state] = runSet (study, set, state)
  problem = study.problem;
  emulator = study.emulator;
  n = state.repeats;
  phi = zeros (1, numel (problem.effects));
  number = zeros (1, numel (set.h));
  for i = 1:numel (set.h)
    number(i) = find (strcmp ({problem.effects.name}, ...
                              study.hypotheses.names{set.h(i)}), 1);
    phi(number(i)) = set.Q(emulator.p + i);
  end
  known = rows (state.data.Z);
  state = spendRuns (state, problem, repmat (set.Q(1:emulator.p), n, 1), ...
                     repmat (phi, n, 1), (1:n)', 'cure');
  Z = state.data.Z(known + 1:end, :);
  isAsked = askedResults (state.budget, problem.bench);
  for at = number
    effect = problem.effects(at);
    if effect.laboratory
      own = Z(:, isAsked);
      Z(:, isAsked) = own + phi(at) * (effect.offset(isAsked) + ...
                                       own * effect.matrix(isAsked, isAsked));
    end
  end
  if ~isempty (emulator.change)
    % runs are of the simulation; what both conditions lack is added as in the
    % emulator
    Z = Z + polyRows (emulator.powers, set.Q(1:emulator.p)) * emulator.change.coef;
  end
  set.Z = Z(all (isfinite (Z(:, isAsked)), 2), :);
  set.verified = true;
  M = predictGap (emulator, set.h, set.Q);
  vague = emulator;
  if ~isempty (emulator.change)
    % of a change surrogates count as exact; these runs are judged as simulations
    vague = emulator.change.plain;
  end
  sd = sqrt (mean (vague.surrogateVar, 1) + ...
             emulator.noiseVar / max (rows (set.Z), 1));
  used = problem.used;
  set.worstZ = max (abs (mean (set.Z(:, used), 1) - M(used)) ./ sd(used));
end

%!test
%! % seven runs are two seeds for each of three sets; five are not enough for
%! % that, so that surrogates stand in and nothing is run
%! [given, data, means] = smallGapLab ();
%! given.value = means ([0.4, 0.6], [0.6, 0, 0, 0, 0]);
%! study = labStudy (given, data);
%! runs = @(X, E, r) means (X, [E, zeros(rows (E), 1)]);
%! for left = [7, 5]
%!   options = gapOptions (struct ('maxNewRuns', left, 'verifyRuns', 5));
%!   state = newGapState (data, options, runs);
%!   [sets, state] = runCures (study, {1, 2}, state);
%!   assert ({sets.h}, {zeros(1, 0), 1, 2});
%!   isRun = left == 7;
%!   assert ([sets.verified], [isRun, isRun, isRun]);
%!   assert (cellfun (@rows, {sets.Z}), 2 * isRun * [1, 1, 1]);
%!   assert (state.budget.new, 6 * isRun);
%! end
%! % a set more, beside those that were compared before
%! more = runCures (study, {3}, setfield (state, 'budget', 'sets', 5), sets);
%! assert ({more.h}, {zeros(1, 0), 1, 2, 3});
%! assert ([more.verified], [false, false, false, true]);

% SPDX-License-Identifier: GPL-3.0-only
