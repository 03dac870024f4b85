% ODDRUNS  Runs that ended in another way than the others at their set do.
%
% CALL: ODD = oddRuns (STATE, PROBLEM)
%
%   ODD  struct: X k x d, jump k x T (result less what the surrogates say), of
%        the odd runs; all n x d, the sets of all runs that have a result, rows
%        n x 1, theirs in STATE.data, isOdd n x 1, which of them are odd; chance
%        (that they are an outcome of the model, and no wrong runs), others (of
%        earlier runs, PROBLEM.others, see knownShapes); [] where no run is odd and
%        none was
%
% Odd are runs that were left out, as a second run at their set is what the
% others foretell (findBadRuns), and the smaller part of three or more runs at
% one set which a gap parts: wider than four times what either part spans, than
% all tolerances, and than four scatters of a run (of four runs one is often 2 off and
% the others lie close). A bin that flows or clogs, a heap that holds or slides.
%
% Such an outcome moves a result the same way each time; a wrong run (start state,
% lost wall) moves it either way. Odds of 9 to 1 before; for each requirement in
% which odd runs are off by more than 4 scatters, twice as much for each further
% run on the same side, a hundredth once there are runs on both sides.

function odd = oddRuns (state, problem)
  odd = [];
  data = runsThatCount (state.data, problem);
  isLeft = any (horzcat (state.surrogates.leftOut), 2);
  isLeft(end + 1:rows (state.data.X), 1) = false;
  counted = find (all (state.data.E == problem.fine, 2));
  known = all (isfinite (data.Z(:, problem.calibrate)), 2);
  X = data.X(known, :);
  Z = data.Z(known, :);
  isOdd = isLeft(counted(known)) | isSplit (X, Z, problem, usualScatter (state));
  others = givenField (problem, 'others', []);
  if any (isOdd) || ~isempty (others)
    odd = struct ('X', X(isOdd, :), 'all', X, 'rows', counted(known), ...
                  'isOdd', isOdd);
    odd.jump = Z(isOdd, :) - usualOf (X, Z, isOdd, state.surrogates);
    odd.chance = chanceOf (odd.jump, sqrt ([state.surrogates.noiseVar]), problem);
    odd.others = others;
  end
  if ~isempty (others)
    odd.chance = 1;
  end
end

function chance = chanceOf (jump, noiseSd, problem)
  odds = 9;
  side = sign (jump) .* (abs (jump) > 4 * noiseSd);
  for group = requirementsOf (problem)
    own = sum (side(:, group{1}), 2);      % of a curve: of most of its points
    if any (own > 0) && any (own < 0)
      odds = odds / 100;
    else
      odds = odds * 2^max (0, sum (own ~= 0) - 1);
    end
  end
  chance = odds / (1 + odds);
end

% What the others gave at the set of each odd run, else the surrogates.
function U = usualOf (X, Z, isOdd, surrogates)
  rowsOf = find (isOdd)';
  U = zeros (0, columns (Z));
  if any (isOdd)
    U = predictSurrogate (surrogates, X(isOdd, :));
  end
  for k = 1:numel (rowsOf)
    mates = all (X == X(rowsOf(k), :), 2) & ~isOdd;
    if any (mates)
      U(k, :) = mean (Z(mates, :), 1);
    end
  end
end

% As the surrogates miss runs that they do not hold. The median, as odd runs are
% fewer than the others: the estimated noise would hold their jump.
function sd = usualScatter (state)
  sd = arrayfun (@(s) median (abs (s.looResidual)) / 0.6745, state.surrogates);
end

function isOdd = isSplit (X, Z, problem, scatter)
  isOdd = false (rows (X), 1);
  [~, ~, set] = unique (X, 'rows');
  for k = find (accumarray (set, 1)' > 2)
    inSet = find (set == k);
    for t = find (problem.calibrate)
      least = max (2 * problem.tol(t) * abs (problem.scale(t)), 4 * scatter(t));
      isOdd(inSet) = isOdd(inSet) | smallerPart (Z(inSet, t), least);
    end
  end
end

function isPart = smallerPart (z, least)
  [sorted, order] = sort (z);
  n = numel (z);
  isPart = false (n, 1);
  [gap, at] = max (diff (sorted));
  spans = [sorted(at) - sorted(1), sorted(end) - sorted(at + 1)];
  if 2 * at ~= n && gap > 4 * max (spans) && gap > least
    part = 1:at;
    if 2 * at > n
      part = at + 1:n;
    end
    isPart(order(part)) = true;
  end
end

%!test
%! [problem, state, ~, f] = smallCalibration ();
%! assert (isempty (oddRuns (state, problem)));
%! Z = f ([0.5, 1]) .* (1 + 0.003 * [1, 0; -1, 0; 0, 1; 0, 0]);
%! Z(2, :) = 0.3 * Z(2, :);
%! state.data = addRows (state.data, repmat ([0.5, 1], 4, 1), Z, (1:4)', ...
%!                       'replicate');
%! for t = 1:2
%!   state.surrogates(t).leftOut(16, 1) = false;
%! end
%! odd = oddRuns (state, problem);
%! assert ({odd.X, size(odd.all)}, {[0.5, 1], [16, 2]});
%! assert (odd.jump, -0.7 * f ([0.5, 1]), 0.05);
%! assert (odd.chance, 0.9, 1e-9);
%! % a run that was left out is one
%! state.surrogates(1).leftOut(3) = true;
%! odd = oddRuns (state, problem);
%! assert (rows (odd.X), 2);
%! % two on one side, on both sides
%! state.data.Z(3, :) = 0.3 * f (state.data.X(3, :));
%! assert (oddRuns (state, problem).chance > 0.9);
%! state.data.Z(3, :) = 1.7 * f (state.data.X(3, :));
%! assert (oddRuns (state, problem).chance < 0.01);
%!test
%! % runs that scatter by 1 %: three lie close by chance, one 2.5 % off is no outcome
%! [problem, state, ~, f] = smallCalibration ();
%! problem.tol(:) = 0.01;
%! Z = f ([0.5, 1]) .* (1 + 0.01 * [0, 0; 0.1, 0; 0.2, 0; 2.5, 0]);
%! state.data = addRows (state.data, repmat ([0.5, 1], 4, 1), Z, (1:4)', 'replicate');
%! for t = 1:2
%!   state.surrogates(t).leftOut(16, 1) = false;
%!   n = numel (state.surrogates(t).looResidual);
%!   state.surrogates(t).looResidual = 0.01 * Z(1, t) * (-1).^(1:n)';
%! end
%! assert (isempty (oddRuns (state, problem)));
%! for t = 1:2
%!   state.surrogates(t).looResidual = 0.002 * Z(1, t) * (-1).^(1:n)';
%! end
%! assert (sum (oddRuns (state, problem).isOdd), 1);

% SPDX-License-Identifier: GPL-3.0-only
