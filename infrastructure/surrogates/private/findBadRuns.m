% FINDBADRUNS  Finds runs that are off by far more than runs scatter.
%
% CALL: [BAD, SUSPECT] = findBadRuns (RUNS, KIND, SURROGATES, OLD)
%
%   RUNS        scalar struct: X (n x d, parameter sets), Z (n x T, responses;
%               NaN: none), extra (1 x T cell, n x 1 a further input of each, or
%               [], see fitSurrogate)
%   KIND        scalar struct of 1 x T: model (number of the model that each
%               response belongs to), weight (1; 1 / n for the n points of a
%               curve, which are one response), least (deviation that is too
%               small to be wrong, say the tolerance, in units of the response),
%               judges (logical: the response is fitted; a run is never bad for
%               one that is held out or not measured)
%   SURROGATES  1 x T struct of fitSurrogate, fitted to all rows but OLD
%   OLD         n x T logical, runs found bad before
%   BAD         n x T logical: all responses of a run share one judgement
%   SUSPECT     n x T logical: would be bad, but nobody has run the set once
%               more
%
% A wrong start state, a lost wall: such a run is neither failed nor scatter.
% With the restricted likelihoods l of all runs and of all but run i, each at
% its own parameters, run i is suspect where the weighted sum over the responses
% of
%
%   l(all but i) - log (6 s) - l(all)    exceeds    log (0.98 / 0.02)
%
% that is against a run that may lie anywhere within 6 standard deviations s of
% the others (Box and Tiao 1968: a small share of runs of another, wide
% distribution). It is bad only where another run at the same set is what the
% others foretell, and off it by 4 scatters: a lone run may be the one that
% shows a peak or a jump, and never are all runs of a set bad. Responses whose
% residuals are alike count as fewer (alikeWeights): an
% avalanche changes slope, height and mass of a heap at once. Added and taken
% back one by one, two at once where one hides the other. A run that is nowhere
% off by more than KIND.least is never bad: it does no harm. At most a quarter
% of the runs; at least d + 3 stay.

function [bad, suspect] = findBadRuns (runs, kind, surrogates, old)
  bad = old;
  suspect = false (size (old));
  for m = unique (kind.model)
    ofModel = kind.model == m;
    judges = find (ofModel & kind.judges);
    if isempty (judges)
      continue
    end
    bad(:, ofModel) = false;
    rowsOf = any (isfinite (runs.Z(:, judges)), 2);
    if ~any (rowsOf)
      continue
    end
    task = struct ('X', runs.X(rowsOf, :), 'Z', runs.Z(rowsOf, judges), ...
                   'surrogates', {surrogates(judges)}, 'extra', [], ...
                   'weight', kind.weight(judges), ...
                   'least', kind.least(judges));
    extra = [runs.extra{ofModel}];       % the same for all of one model
    if ~isempty (extra)
      task.extra = extra(rowsOf, 1);
    end
    [~, ~, task.set] = unique ([task.X, task.extra], 'rows');
    [out, doubt] = judge (task, any (old(rowsOf, judges), 2));
    bad(rowsOf, ofModel) = repmat (out, 1, sum (ofModel));
    suspect(rowsOf, ofModel) = repmat (doubt, 1, sum (ofModel));
  end
end

function [out, suspect] = judge (task, out)
  T = numel (task.surrogates);
  suspect = false (size (out));
  far = arrayfun (@(t) max (abs (task.surrogates(t).looStd)), 1:T);
  if ~any (out) && all (far < 2)
    return
  end
  odds = log (0.98 / 0.02);
  now = fitWithout (task, out);
  task.weight = alikeWeights (task.weight, now.residual);
  % a run that was bad before may fit now that more is known
  for i = find (out)'
    tried = fitWithout (task, setfield (now.out, {i}, false));
    if evidence (now, task) - evidence (tried, task) < odds
      now = tried;
    end
  end
  n = rows (task.X);
  most = min (floor (n / 4), n - columns (task.X) - 3);
  isMore = true;
  while isMore
    [now, isMore] = leaveMoreOut (task, now, most, odds);
  end
  suspect = now.out & isAlone (task.set, true (n, 1));
  out = now.out & ~suspect & isForetold (task, now);
end

% Rows of KEPT that are the only kept ones of their set.
function yes = isAlone (set, kept)
  n = accumarray (set, kept);
  yes = n(set) == 1;
end

% Other runs of the set are where all others say, within 3 deviations, and the
% run is off them by 4 scatters: runs of DEM scatter with wide tails.
function yes = isForetold (task, now)
  yes = false (size (now.out));
  for i = find (now.out)'
    mates = task.set == task.set(i) & ~now.out & now.far < 3;
    off = abs (task.Z(i, :) - mean (task.Z(mates, :), 1));
    yes(i) = any (mates) && any (off > 4 * now.noiseSd);
  end
end

function e = evidence (judged, task)
  e = judged.gain * task.weight';
end

% The worst run, the second worst, or both, whichever gains most.
function [now, isMore] = leaveMoreOut (task, now, most, odds)
  before = now;
  best = odds;
  isMore = false;
  [far, order] = sort (now.far, 'descend');
  if far(1) < 2
    return
  end
  for pick = {order(1), order(2), order(1:2)}
    n = numel (pick{1});
    out = setfield (before.out, {pick{1}}, true);
    isLost = accumarray (task.set, ~out) == 0 & accumarray (task.set, 1) > 1;
    if sum (out) > most || any (isLost)
      continue
    end
    tried = fitWithout (task, out);
    gain = evidence (tried, task) - evidence (before, task) - (n - 1) * odds;
    if gain > best
      best = gain;
      now = tried;
      isMore = true;
    end
  end
end

%!function [bad, suspect] = judged (X, Z, kind, s, old)
%!  kind.judges = givenField (kind, 'judges', true (1, columns (Z)));
%!  runs = struct ('X', X, 'Z', Z, 'extra', {cell(1, columns (Z))});
%!  [bad, suspect] = findBadRuns (runs, kind, s, old);
%!endfunction
%!function s = fitted (X, z)
%!  % as the refits of a calibration are
%!  s = fitSurrogate (X, z, [0, 0, 0; 1, 1, 1], struct ('quick', true));
%!endfunction
%!function bad = found (X, Z, kind, old)
%!  for t = columns (Z):-1:1
%!    s(t) = fitted (X, Z(:, t));
%!  end
%!  [bad, suspect] = judged (X, Z, kind, s, old);
%!  bad = bad | suspect;
%!endfunction
%!shared X, Z, kind, none
%! rand ('twister', 3);
%! randn ('twister', 3);
%! X = rand (16, 3);
%! Z = [3 + 2 * X(:, 1) - X(:, 3), 1 + X(:, 1) + X(:, 2)] .* ...
%!     (1 + 0.01 * randn (16, 2));
%! kind = struct ('model', [1, 1], 'weight', [1, 1], 'least', [0, 0]);
%! none = false (16, 2);

%!test
%! % nothing is wrong
%! assert (found (X, Z, kind, none), none);

%!test
%! % two wrong runs; what is found stays found, a run that is good comes back
%! W = Z;
%! W([4, 9], :) = W([4, 9], :) .* [1.3, 0.7; 0.75, 1.25];
%! bad = found (X, W, kind, none);
%! assert (find (bad(:, 1))', [4, 9]);
%! assert (bad(:, 1), bad(:, 2));
%! wrong = none;
%! wrong(2, :) = true;
%! assert (found (X, W, kind, bad | wrong), bad);

%!test
%! % each model of its own; a failed run is none of its business
%! W = Z;
%! W(5, 1) = 2 * W(5, 1);
%! W(7, 2) = NaN;
%! assert (find (found (X, W, setfield (kind, 'model', [1, 2]), none))', 5);

%!test
%! % what is off by less than matters is not wrong
%! W = Z;
%! W(4, :) = 1.08 * W(4, :);
%! assert (find (found (X, W, kind, none)(:, 1)), 4);
%! assert (found (X, W, setfield (kind, 'least', [1, 1]), none), none);

%!test
%! % responses with one scatter are one proof, not three; a run that is far off
%! % is found, be the scatter one or their own
%! kind = struct ('model', [1, 1, 1], 'weight', [1, 1, 1], 'least', [0, 0, 0]);
%! law = [3 + 2 * X(:, 1) - X(:, 3), 4 + X(:, 1) + X(:, 2), 2 + X(:, 2)];
%! off = [0.12, 0.2];
%! isFound = false (2, 2);
%! for i = 1:2
%!   randn ('twister', 8);
%!   own = 0.03 * randn (16, 3);
%!   own(4, :) = off(i);
%!   shared = own(:, [1, 1, 1]) + 0.003 * randn (16, 3);
%!   isFound(1, i) = any (found (X, law + shared, kind, false (16, 3))(:));
%!   bad = found (X, law + own, kind, false (16, 3));
%!   isFound(2, i) = isequal (find (bad(:, 1)), 4);
%! end
%! assert (isFound, logical ([0, 1; 0, 1]));
%!test
%! % many points of a curve are one response: off by 3 deviations is no proof
%! randn ('twister', 5);
%! curve = repmat (Z(:, 1) + 0.05 * (1:16 == 4)', 1, 6);
%! kind = struct ('model', ones (1, 6), 'weight', ones (1, 6) / 6, ...
%!                'least', zeros (1, 6));
%! s = repmat (fitted (X, curve(:, 1)), 1, 6);
%! none = false (16, 6);
%! [~, bad] = judged (X, curve, kind, s, none);
%! far = repmat (Z(:, 1) + 0.5 * (1:16 == 4)', 1, 6);
%! s(:) = fitted (X, far(:, 1));
%! [~, alone] = judged (X, far, kind, s, none);
%! assert ([any(bad(:)), any(alone(:))], [false, true]);
%!test
%! % a run alone at its set is suspect; bad where a second one is as the others
%! % foretell; both count where they agree; not judged by what is held out
%! kind = struct ('model', [1, 1], 'weight', [1, 1], 'least', [0, 0]);
%! none = false (16, 2);
%! W = [Z; Z(4, :)];
%! W(4, 1) = 2 * W(4, 1);
%! P = X([1:16, 4], :);
%! for t = 1:2
%!   s(t) = fitted (P, W(:, t));
%! end
%! [bad, suspect] = judged (P, W, kind, s, false (17, 2));
%! assert (find (bad(:, 1))', 4);
%! assert (! any (suspect(:)));
%! W(17, 1) = 0.99 * W(4, 1);
%! [bad, suspect] = judged (P, W, kind, s, false (17, 2));
%! assert (! any ([bad(:); suspect(:)]));
%! kind.judges = [false, true];
%! [bad, suspect] = judged (X, W(1:16, :), kind, s, none);
%! assert (! any ([bad(:); suspect(:)]));
%!test
%! % runs that lack a response count for those they have
%! kind = struct ('model', [1, 1], 'weight', [1, 1], 'least', [0, 0]);
%! none = false (16, 2);
%! W = Z;
%! W(1:6, 1) = NaN;
%! W(11:16, 2) = NaN;
%! W(12, 1) = 1.4 * W(12, 1);
%! bad = found (X, W, kind, none);
%! assert (find (bad(:, 1))', 12);

% SPDX-License-Identifier: GPL-3.0-only
