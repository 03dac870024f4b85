% EQUALRUNS  Two runs at different sets that cannot both be their own.
%
% CALL: [PAIR, SHARED] = equalRuns (DATA, PROBLEM)
%
%   DATA     see newData;  PROBLEM  bench, limits and unit are read
%   PAIR     1 x 2: rows of DATA; [] where nothing is proven
%   SHARED   1 x m: the results of a model that they share to the last digit
%
% Runs scatter, so two of them agree in a result of n digits about once in 10^n.
% Where all runs write to one file, one of them reads what another has written: all
% results of a model, or one, whose file alone is shared.
% Proof takes ten digits, of one pair or of several, of one result alone fifteen, where a
% result of a run counts as five at most: rounded results, counts (also times the mass of a
% grain), and results with few digits prove nothing. Compared are runs of the same effects:
% those of another filling have other steps. Nor does a result that is saturated: at an end
% of what the runs gave (nothing flows, and its ratios are 0). Sets that have half of
% their parameters in common may differ in what a model does not have; one result may be
% of any parameter alone.

function [pair, shared] = equalRuns (data, problem)
  range = diff (problem.limits(1:2, :), 1, 1);
  for k = unique (problem.bench)
    own = find (problem.bench == k);
    groups = {own};
    if numel (own) > 1
      groups = [groups, num2cell(own)];
    end
    for g = groups
      shared = g{1};
      asked = [10, 0.5];
      if numel (shared) < numel (own)
        asked = [15, 0.99];
      end
      pair = provenAlike (data, shared, problem.unit(shared), range, asked);
      if ~isempty (pair)
        return
      end
    end
  end
end

% Among the runs of each choice of effects.
function pair = provenAlike (data, varargin)
  pair = [];
  [~, ~, alike] = unique ([zeros(rows (data.X), 1), data.E], 'rows');
  for a = 1:max ([alike; 0])
    own = find (alike == a);
    if numel (own) > 1 && isempty (pair)
      pair = own(proven (keepRows (data, own), varargin{:}))';
    end
  end
end

% ASKED: how many digits are proof, and which share of the parameters has to differ.
function pair = proven (data, results, unit, range, asked)
  pair = [];
  whole = find (all (isfinite (data.Z(:, results)), 2));
  Z = data.Z(whole, results);
  nDigits = digitsOf (Z .* unit);
  digits = zeros (0, 1);
  found = zeros (0, 2);
  [~, ~, group] = unique (Z, 'rows');
  for g = find (accumarray (group, 1, [max([group; 0]), 1]) > 1)'
    rows_ = find (group == g);
    z = Z(rows_(1), :);
    X = data.X(whole(rows_), :);
    % sets that are alike to a thousandth of the limits may give one number
    isApart = mean (abs (X - X(1, :)) > 1e-3 * range, 2) > asked(2);
    if any (isApart)
      found(end + 1, :) = whole(rows_([1, find(isApart, 1)]));
      isInside = z < max (Z, [], 1) & z > min (Z, [], 1);
      [~, first] = unique (z .* unit);
      digits(end + 1) = sum (nDigits(rows_(1), first(isInside(first))));
    end
  end
  found = found(digits >= 5, :);
  if sum (digits(digits >= 5)) >= asked(1)
    pair = found(1, :);
  end
end

% Digits of each result, five at most; of counts those of the largest number of steps.
function n = digitsOf (Z)
  n = zeros (size (Z));
  for t = 1:columns (Z)
    steps = stepsOf (Z(:, t));
    for k = 1:rows (Z)
      digits = regexprep (sprintf ('%.12e', Z(k, t)), {'e.*$', '[-+.]', '0+$'}, '');
      n(k, t) = min ([numel(digits), log10(steps), 5]);
    end
  end
end

% How many steps are between the ends of a result: of counts, and of what is one times
% a constant, all differences are multiples of one; Inf of others, and of few.
function n = stepsOf (z)
  n = Inf;
  gaps = sort (diff (unique (z)));
  gaps = gaps(gaps > 1e-9 * max (abs (z)));      % of one number, computed in two ways
  if numel (gaps) < 5
    return
  end
  for part = 1:3
    step = gaps(1) / part;
    counts = zeros (size (gaps));
    for k = 1:numel (gaps)                       % a file rounds: a step is known better
      counts(k) = round (gaps(k) / step);
      step = sum (gaps(1:k)) / sum (counts(1:k));
    end
    if all (abs (gaps / step - counts) < 0.1)
      n = sum (counts);
      return
    end
  end
end

%!function [pair, shared] = of (X, Z, bench)
%!  data = addRows (newData (columns (X), columns (Z)), X, Z, ones (rows (X), 1), 'plan');
%!  [pair, shared] = equalRuns (data, struct ('bench', bench, 'unit', ones (size (bench)), ...
%!                                  'limits', [zeros(1, columns (X)); ones(1, columns (X))]));
%!endfunction
%!shared X, Z
%! rand ('twister', 1);
%! X = rand (12, 2);
%! Z = round (1e5 * (1 + X)) / 1e5;
%!assert (of (X, Z, [1, 1]), [])
%!test
%! odd = Z;
%! [~, order] = sort (Z(:, 1));
%! odd(order(5), :) = Z(order(7), :);
%! assert (sort (of (X, odd, [1, 1])), sort (order([5, 7])'));
%! % of the second of two models; one result of 6 digits alone is chance
%! assert (of (X, [odd(:, 1), 2 * Z(:, 1)], [1, 2]), []);
%! [pair, shared] = of (X, [Z, odd], [1, 1, 2, 2]);
%! assert ({pair, shared}, {sort(order([5, 7])'), [3, 4]});
%! % two such pairs are none
%! odd(order(2), :) = Z(order(9), :);
%! assert (! isempty (of (X, odd(:, 1), 1)));
%!test
%! % counts, a saturated response, another packing, a parameter of another model
%! assert (of (X, round (10 * Z), [1, 1]), []);
%! assert (of (X, min (Z, 1.212345), [1, 1]), []);
%! assert (of ([X; X(3, :)], [Z; Z(3, :)], [1, 1]), []);
%! assert (of ([X; X(3, 1), 9], [Z; Z(3, :)], [1, 1]), []);
%! assert (of (X, NaN (12, 2), [1, 1]), []);
%! % two sets that are nearly one
%! assert (of ([X; X(3, :) + 1e-5], [Z; Z(3, :)], [1, 1]), []);
%!test
%! % a rig from which nothing comes, twice: its mass, and what is relative to it
%! few = [-7.44065049, 0, 0];
%! assert (of (X, [few; few; [Z, Z(:, 1)](3:end, :)], [1, 1, 1]), []);

%!test
%! % of one file of two: three pairs of other sets are proof, and no two
%! odd = Z;
%! [~, order] = sort (Z(:, 2));
%! odd(order([3, 5]), 2) = Z(order([8, 9]), 2);
%! assert (of (X, odd, [1, 1]), []);
%! odd(order(7), 2) = Z(order(10), 2);
%! [pair, shared] = of (X, odd, [1, 1]);
%! assert ({rows(pair), shared}, {1, 2});
%! % a parameter in common may be all that it depends on
%! fixed = [0 * X(:, 1), X(:, 2)];
%! assert (of (fixed, odd, [1, 1]), []);
%!test
%! % grains that flowed times the mass of one, as a file of six digits has it
%! rand ('twister', 2);
%! many = rand (60, 2);
%! mass = arrayfun (@(n) str2double (sprintf ('%.6g', 4.18879e-6 * n)), ...
%!                  300 + round (many * [400; 200]));
%! assert (numel (unique (mass)) < 57);
%! assert (of (many, mass, 1), []);
%! % the share of another filling times its mass: the same number but for its last digit
%! n = 300 + round (many * [400; 200]);
%! mass = [4.18879e-6 * 900 * (n(1:50) / 900); 4.18879e-6 * 1100 * (n(1:10) / 1100)];
%! assert (of ([many(1:50, :); 1 - many(1:10, :)], [mass, exp(-(1:60)')], [1, 1]), []);
%! % a share of 900 grains or of 1100, as an effect makes them: of each the steps are its own
%! data = addRows (newData (2, 1, 1), many, n ./ [900 * ones(30, 1); 1100 * ones(30, 1)], ...
%!                 ones (60, 1), 'gap', [zeros(30, 1); ones(30, 1)]);
%! given = struct ('bench', 1, 'unit', 1, 'limits', [0, 0; 1, 1]);
%! assert (equalRuns (data, given), []);

% SPDX-License-Identifier: GPL-3.0-only
