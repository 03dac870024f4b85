% COMPAREVARIANTS  Whether cheaper runs give the results that dearer ones gave.
%
% CALL: LIST = compareVariants (Z, S, ALLOWED)
%
%   Z        1 x V cell of R x T: results of R runs of a variant, NaN where a run
%            has none; the first variant is what the others are compared with
%   S        1 x V cell of R x 1: core-seconds of each run
%   ALLOWED  1 x T, tolerance of each result, in its unit (half its band); NaN:
%            the result is not looked at
%   LIST     1 x V struct: cost (core-seconds for each run with results), ratio
%            (1 x 3: over those of the first, with its 90 % interval), lost (runs
%            without results), shift (1 x T: difference of the means), worst
%            (number of the result that decides, of 'open' the one that needs the
%            most runs), code ('base', 'same', 'differs', 'near': a shift of about
%            half the tolerance, 'open', 'failed'), runs (of each variant that would
%            probably decide; NaN: no number)
%
% The same are results whose shift surely (95 %, one side, all results together:
% Bonferroni) lies within half of the tolerance, as the other half is for the
% calibration itself; they differ where it surely lies beyond (two one-sided
% tests, Schuirmann 1987, J. Pharmacokinetics and Biopharmaceutics 15). The
% scatter of a result is taken as equal in the first variant and the one compared.

function list = compareVariants (Z, S, allowed)
  isOk = cellfun (@(z) all (isfinite (z), 2), Z, 'UniformOutput', false);
  n = cellfun (@sum, isOk);
  tries = cellfun (@numel, isOk) ./ n;   % a run without results is made again
  lost = num2cell (cellfun (@numel, isOk) - n);
  Z = cellfun (@(z, ok) z(ok, :), Z, isOk, 'UniformOutput', false);
  S = cellfun (@(s, ok) s(ok), S, isOk, 'UniformOutput', false);
  half = allowed / 2;
  judged = find (isfinite (half) & half > 0);
  list = repmat (struct ('cost', NaN, 'ratio', NaN (1, 3), 'shift', NaN (size (half)), ...
                         'worst', judged(1:min (end, 1)), 'code', 'failed', 'runs', NaN, ...
                         'lost', 0), 1, numel (Z));
  [list.lost] = lost{:};
  if n(1) < 2 || isempty (judged)
    return
  end
  list(1).code = 'base';
  [list(1).ratio, list(1).shift] = deal (ones (1, 3), zeros (size (half)));
  list(1).cost = mean (S{1}) * tries(1);
  for k = 1 + find (n(2:end) > 1 & n(2:end) >= n(1) / 2)
    variant = list(k);
    [shift, bound] = difference (log (S{1}), log (S{k}), 0.05);
    variant.ratio = exp (shift + bound * [0, -1, 1]) * tries(k) / tries(1);
    variant.cost = mean (S{k}) * tries(k);
    [variant.shift, bound] = difference (Z{1}, Z{k}, 0.05 / numel (judged));
    % as shares of half the tolerance
    [variant.code, worst, variant.runs] = ...
      judge (abs (variant.shift(judged)) ./ half(judged), bound(judged) ./ half(judged), ...
             2 / (1 / n(1) + 1 / n(k)));
    variant.worst = judged(worst);
    list(k) = variant;
  end
end

% Means of B less those of A, and by how much they are surely (but for a chance of
% P) off at most, to one side.
function [shift, bound] = difference (A, B, p)
  [n, m] = deal (rows (A), rows (B));
  shift = mean (B, 1) - mean (A, 1);
  spread = sumsq (A - mean (A, 1), 1) + sumsq (B - mean (B, 1), 1);
  bound = studentQuantile (1 - p, n + m - 2) * ...
          sqrt (spread / (n + m - 2) * (1 / n + 1 / m));
end

% RUNS would narrow the doubt of N runs to what lies between shift and bound.
function [code, worst, runs] = judge (share, doubt, n)
  runs = NaN;
  [code, value] = deal ('open', share + doubt);
  if all (share + doubt <= 1)
    code = 'same';
  elseif any (share - doubt > 1)
    [code, value] = deal ('differs', share - doubt);
  else
    value = n * (doubt ./ abs (1 - share)).^2 .* (share + doubt > 1);
    runs = ceil (max (value));
  end
  [~, worst] = max (value);
  if strcmp (code, 'open') && abs (1 - share(worst)) < 0.1
    [code, runs] = deal ('near', NaN);
  end
end

%!test
%! % one of the same results at half the cost, one that is off, one too scattered
%! z = [-1; 0; 1; 0] * 0.1;
%! Z = {[10 + z, 5 + z], [10.01 + z, 5 - z], [12 + z, 5 + z]};
%! S = {[10; 10; 11; 9], [5; 5; 5.5; 4.5], [1; 1; 1; 1]};
%! list = compareVariants (Z, S, [1, 1]);
%! assert ({list.code}, {'base', 'same', 'differs'});
%! assert (list(2).ratio(1), 0.5, 1e-3);
%! assert (list(2).ratio(2) < 0.5 && list(2).ratio(3) > 0.5);
%! assert (list(1).ratio, [1, 1, 1]);
%! assert (list(3).worst, 1);
%! assert (list(3).shift, [2, 0], 1e-12);
%! list = compareVariants (Z, S, [0.2, 0.2]);
%! assert (list(2).code, 'open');
%! assert (list(2).runs > 4);
%! % told is the result that leaves it open: the second lies at half its tolerance
%! Y = {[10 + z, 5 + z], [10.3 + z, 5.1 + z]};
%! list = compareVariants (Y, S(1:2), [0.9, 0.21]);
%! assert ({list(2).code, list(2).worst}, {'near', 2});
%! % a third variant that scatters leaves the others as known as they are
%! Y = {[10 + z, 5 + z], [10 + z, 5 + z], [10 + 50 * z, 5 + z]};
%! assert ({compareVariants(Y, S, [1, 1]).code}, {'base', 'same', 'open'});
%! % what is not looked at decides nothing; nor does a variant without results
%! list = compareVariants (Z, S, [NaN, 1]);
%! assert (list(3).code, 'same');
%! % one of four runs lost: the other three cost a third more
%! Z{2}(1, :) = NaN;
%! list = compareVariants (Z, S, [1, 1]);
%! assert ([list.lost], [0, 1, 0]);
%! assert (list(2).ratio(1), 0.5 * 4 / 3, 0.02);
%! Z{2}(1:3, :) = NaN;
%! assert (compareVariants (Z, S, [1, 1])(2).code, 'failed');
%!test
%! % of equal results the wrong answer 'same' at a shift of half the tolerance comes
%! % in at most 5 % of cases (fixed seed; 400 draws: 8 % would be 3 deviations off)
%! randn ('state', 3);
%! wrong = 0;
%! for i = 1:400
%!   Z = {randn(4, 1), randn(4, 1) + 2};
%!   wrong = wrong + strcmp (compareVariants (Z, {ones(4, 1), ones(4, 1)}, 4)(2).code, 'same');
%! end
%! assert (wrong / 400 < 0.08);

% SPDX-License-Identifier: GPL-3.0-only
