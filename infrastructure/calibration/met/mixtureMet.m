% MIXTUREMET  Probability that all is met where some runs end in another way.
%
% CALL: [P, SHARE] = mixtureMet (R, S, PROBLEM, DF, AT)
%
%   R, S, DF  see allMet: of the usual outcome; PROBLEM.odd  see oddRuns; without
%             it, or where it is [], P is that of allMet; its field further
%             (optional): so many more runs at the set that end as usual
%   AT        n x d, the sets
%   P         n x 1: the mean over both outcomes is within all tolerances
%   SHARE     n x 1, expected share of runs that end in the other way
%
% The share q of the other outcome at a set is Beta (a, b + 1) distributed: a odd
% runs and b others, each counted by exp (-(u / 0.15)^2 / 2) at u box widths (the
% diagonal is sqrt (d)). So far from all odd runs nothing changes, and at a set
% next to one it takes many runs without another odd one to bound q: the mean
% over both outcomes moves by q times the jump. All this with PROBLEM.odd.chance
% (default 1), else the odd runs are wrong ones and tell nothing. What earlier runs of the
% rig say (PROBLEM.odd.others, see knownShapes) counts as two runs within their region, and
% less beyond it.
%
% PROBLEM.avoid (m x d, optional) holds sets at which runs failed again and
% again: the probability falls to 0 within a tenth of the box around them.

function [p, share] = mixtureMet (r, s, problem, df, at)
  share = zeros (rows (at), 1);
  odd = givenField (problem, 'odd', []);
  isNear = false (rows (at), 1);
  if ~isempty (odd)
    [a, b, jump] = countedNear (at, odd, problem);
    chance = givenField (odd, 'chance', 1);
    share = chance * a ./ (a + b + 1);
    isNear = a > 0.02;
  end
  p = zeros (rows (at), 1);
  p(~isNear) = allMet (r(~isNear, :), s(~isNear, :), problem, df);
  if any (isNear)
    q = @(part) betaincinv (part, a(isNear), b(isNear) + 1);
    [~, slope] = targetResidual (problem, at(isNear, :), ...
                                 repmat (problem.value, sum (isNear), 1));
    jump = slope .* jump(isNear, :) ./ a(isNear);
    p(isNear) = ofBoth (r(isNear, :), s(isNear, :), problem, df, jump, q);
  end
  p = p .* awayFrom (givenField (problem, 'avoid', []), at, problem);
end

% Odd runs near each set, others, and the sum of the jumps of the odd ones.
function [a, b, jump] = countedNear (at, odd, problem)
  W = weights (at, odd.X, problem);
  a = sum (W, 2);
  b = sum (weights (at, odd.all, problem), 2) - a + givenField (odd, 'further', 0);
  jump = W * odd.jump;
  for other = givenField (odd, 'others', [])
    w = 2 * weightOfBox (at, other, problem);
    a = a + w * other.share;
    b = b + w * (1 - other.share);
    jump = jump + w * other.share * (other.times - 1) .* problem.value;
  end
  b = max (b, 0);
end

function w = weightOfBox (at, other, problem)
  nearest = min (max (at, other.low), other.high);
  apart = toUnit (at, problem.limits) - toUnit (nearest, problem.limits);
  w = nearness (apart);
end

% APART  n x d, in box widths
function w = nearness (apart)
  w = exp (-sumsq (apart / (0.15 * sqrt (columns (apart))), 2) / 2);
end

% The mean over the quantiles Q of the share of the other outcome.
function p = ofBoth (r, s, problem, df, jump, q)
  chance = givenField (problem.odd, 'chance', 1);
  p = (1 - chance) * allMet (r, s, problem, df);
  for part = ((1:8) - 0.5) / 8
    p = p + chance / 8 * allMet (r + q (part) .* jump, s, problem, df);
  end
end

function share = awayFrom (avoid, at, problem)
  share = ones (rows (at), 1);
  U = toUnit (at, problem.limits);
  for i = 1:rows (avoid)
    apart = sumsq (U - toUnit (avoid(i, :), problem.limits), 2);
    share = share .* (1 - exp (-100 * apart));
  end
end

function W = weights (at, X, problem)
  U = toUnit (at, problem.limits);
  V = toUnit (X, problem.limits);
  W = zeros (rows (U), rows (V));
  for i = 1:rows (V)
    W(:, i) = nearness (U - V(i, :));
  end
end

%!shared problem, p
%! problem = smallProblem (2, 0.05);
%! p = mixtureMet (0, 0.01, problem, 1e6, 0.5);
%!test
%! % no odd run, or far away: one outcome
%! assert (p, 1, 1e-4);
%! problem.odd = struct ('X', 0, 'all', [0; 0; 0.5; 0.5], 'jump', -2);
%! assert (mixtureMet (0, 0.01, problem, 1e6, 0.9), p, 1e-6);
%!test
%! % one of n runs at the set gives nothing: the share is Beta (1, n), and must
%! % be below 0.05: 1 - 0.95^n
%! for n = [5, 60]
%!   problem.odd = struct ('X', 0.5, 'all', 0.5 * ones (n, 1), 'jump', -2);
%!   [p, share] = mixtureMet (0, 1e-6, problem, 1e6, 0.5);
%!   assert (p, 1 - 0.95^n, 0.07);
%!   assert (share, 1 / (n + 1), 1e-9);
%! end
%! problem.odd.chance = 0;
%! assert (mixtureMet (0, 1e-6, problem, 1e6, 0.5), 1, 1e-3);
%! problem.odd.chance = 1;
%! problem.odd.further = 200;
%! assert (mixtureMet (0, 1e-6, problem, 1e6, 0.5), 1, 1e-3);
%!test
%! % none of the own runs was odd, but earlier ones of this rig were, above 0.6: some
%! % thirty own runs there outweigh them, elsewhere they say nothing
%! seen = struct ('low', 0.6, 'high', 1, 'share', 0.3, 'times', 0.3);
%! of = @(n) struct ('X', zeros (0, 1), 'all', 0.8 * ones (n, 1), ...
%!                   'jump', zeros (0, 1), 'chance', 1, 'others', seen);
%! p = @(n, at) mixtureMet (0, 1e-3, setfield (problem, 'odd', of (n)), 1e6, at);
%! assert (p (0, 0.8) < 0.6 && p (5, 0.8) < 0.9 && p (35, 0.8) > 0.95);
%! assert (p (0, 0.1), 1, 1e-3);

% SPDX-License-Identifier: GPL-3.0-only
