% EQUALRUNS  Two runs at different sets that cannot both be their own.
%
% CALL: PAIR = equalRuns (DATA, PROBLEM)
%
%   DATA     see newData;  PROBLEM  bench, limits and unit are read
%   PAIR     1 x 3: rows of DATA, and number of the model, all of whose results
%            they share to the last digit; [] where nothing is proven
%
% Runs scatter, so two of them agree in a result of n digits about once in 10^n.
% Where all runs write to one file, one of them reads what another has written.
% Proof takes ten digits, of one pair or of several: rounded results, counts, and
% results with few digits prove nothing. Nor does a result that is saturated: at an
% end of what the runs gave (nothing flows, and its ratios are 0). Sets that have half of
% their parameters in common may differ in what a model does not have.

function pair = equalRuns (data, problem)
  pair = [];
  range = diff (problem.limits(1:2, :), 1, 1);
  for k = unique (problem.bench)
    Z = data.Z(:, problem.bench == k);
    whole = find (all (isfinite (Z), 2));
    unit = problem.unit(problem.bench == k);
    Z = Z(whole, :);
    digits = zeros (0, 1);
    found = zeros (0, 2);
    [~, ~, group] = unique (Z, 'rows');
    for g = find (accumarray (group, 1, [max([group; 0]), 1]) > 1)'
      rows_ = find (group == g);
      z = Z(rows_(1), :);
      X = data.X(whole(rows_), :);
      % sets that are alike to a thousandth of the limits may give one number
      isApart = mean (abs (X - X(1, :)) > 1e-3 * range, 2) > 0.5;
      if any (isApart)
        found(end + 1, :) = whole(rows_([1, find(isApart, 1)]));
        isInside = z < max (Z, [], 1) & z > min (Z, [], 1);
        digits(end + 1) = digitsOf (unique (z(isInside) .* unit(isInside)));
      end
    end
    found = found(digits >= 5, :);
    if sum (digits(digits >= 5)) >= 10
      pair = [found(1, :), k];
      return
    end
  end
end

function n = digitsOf (values)
  n = 0;
  for value = values
    n = n + numel (regexprep (sprintf ('%.12e', value), {'e.*$', '[-+.]', '0+$'}, ''));
  end
end

%!function pair = of (X, Z, bench)
%!  data = addRows (newData (columns (X), columns (Z)), X, Z, ones (rows (X), 1), 'plan');
%!  pair = equalRuns (data, struct ('bench', bench, 'unit', ones (size (bench)), ...
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
%! assert (sort (of (X, odd, [1, 1])(1:2)), sort (order([5, 7])'));
%! % of the second of two models; one result of 6 digits alone is chance
%! assert (of (X, [odd(:, 1), 2 * Z(:, 1)], [1, 2]), []);
%! assert (of (X, [Z, odd], [1, 1, 2, 2]), ...
%!         [sort(order([5, 7])'), 2]);
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

% SPDX-License-Identifier: GPL-3.0-only
