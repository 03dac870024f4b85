% READINGSALONE  Whether the readings themselves bear a change that the model sees.
%
% CALL: ALONE = readingsAlone (PROBLEM, EMULATOR, THETA)
%
%   PROBLEM   struct of newProblem, of a change
%   EMULATOR  of emulateChange
%   THETA     1 x p, fitted null model, parameters in [-1, 1]
%   ALONE     struct p (of the gate), each (1 x n, that of each of PROBLEM.used), and
%             decides: logical, these are the p; else no p is less than these, 0 where
%             the readings bear the change, or there is no reference
%
% What is measured now is compared with what the reference and the model foretell
% together. Where the model misses the reference, that may lie far from both readings
% though these agree. So the change of the readings alone, y - r with its own noise, is
% laid along what the model misses, d = y - m:
%   t = d' C^-1 (y - r) / sqrt (d' C^-1 R C^-1 d),
% C and R the covariances of d and of y - r. Below one standard deviation there is no
% change that a model could explain: the least p is then the chance of that (0.16 and
% more). Up to three readings tell no causes apart, and the model is of no use to them:
% their own p (changeOfReadings), corrected for the look at several (Sidak 1967), decides.

function alone = readingsAlone (problem, emulator, theta)
  used = problem.used;
  alone = struct ('p', 0, 'each', zeros (1, numel (used)), 'decides', false);
  if isempty (emulator.change)
    return
  end
  reference = problem.reference;
  isThere = isfinite (reference.value(used));
  at = used(isThere);
  if isempty (at)
    return
  end
  change = emulator.change;
  if numel (used) <= 3
    alone.decides = all (isThere);
  end
  if alone.decides
    each = changeOfReadings (problem, change)(used);
    alone.each = -expm1 (numel (used) * log1p (-min (each, 1 - eps (1))));
    alone.p = min (alone.each);
    return
  end
  R = change.fresh + change.before - reference.together - reference.together';
  R = R(at, at);
  step = (problem.value(at) - reference.value(at))';
  d = (problem.value(at) - polyRows (emulator.powers, theta) * emulator.coef(:, at))';
  w = change.covariance(at, at) \ d;
  alone.p = least (w' * step / sqrt (max (w' * R * w, realmin)));
  % of one reading either way counts
  each = arrayfun (@(t) 2 * least (t), sign (d) .* step ./ sqrt (diag (R)));
  alone.each(isThere) = min (each', 1);
end

function p = least (t)
  p = normalTail (t) * (t < 1);
end

%!function e = withoutFirst (e)
%!  e = handMadeEmulator (e.coef(:, 3:4));
%!  e.range = [10, 10];
%!  e.noiseVar(:) = 1e-6;
%!endfunction
%!shared emulator, given
%! emulator = handMadeEmulator ([0, 0, 0, 0; 3, 1, 0, 0]);
%! emulator.noiseVar(:) = 1e-6;
%! given = struct ('value', [1.5, 0.5, 2.1, 2], 'sd', ones (1, 4), 'limits', [0; 1], ...
%!                 'bench', ones (1, 4), 'tol', 0.01 * ones (1, 4), 'scale', ones (1, 4));
%! given.reference = struct ('value', [1.5, 0.5, 2, -2], 'sd', ones (1, 4));
%!test
%! % the third reading is as before, far from the model; the fourth has changed
%! problem = newProblem (given);
%! alone = readingsAlone (problem, emulateChange (emulator, problem), 0.5);
%! assert (alone.p, 0);
%! assert (alone.each(3) > 0.9 && alone.each(4) == 0);
%!test
%! % no reading has changed
%! given.value(4) = -2.1;
%! problem = newProblem (given);
%! alone = readingsAlone (problem, emulateChange (emulator, problem), 0.5);
%! assert (alone.p > 0.3);
%! assert (readingsAlone (problem, emulator, 0.5), ...
%!         struct ('p', 0, 'each', zeros (1, 4), 'decides', false));
%!test
%! % two readings: one changed by 4 standard deviations, whatever the model gives
%! few = newProblem (ofTargets (newProblem (given), 3:4));
%! [few.value, few.reference.value] = deal ([2, 4 * sqrt(2) - 2], [2, -2]);
%! alone = readingsAlone (few, emulateChange (withoutFirst (emulator), few), 0.5);
%! assert (alone.decides);
%! assert (alone.each, [1, 4 * normalTail(4)], 1e-5);
%! assert (alone.p, alone.each(2));

% SPDX-License-Identifier: GPL-3.0-only
