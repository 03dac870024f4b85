% SCATTEROFCHANGE  Whether trials of a change scatter more than the reference's.
%
% CALL: [RATIO, P] = scatterOfChange (VALUES, SESSIONS, REPEATS, VARIANCE, FREEDOM)
%
%   VALUES, SESSIONS, REPEATS  n x 1, trials of one quantity in the change, the number
%                     of the session of each, and of how many trials it is the mean
%   VARIANCE, FREEDOM  of a trial, as the reference tells it
%   RATIO    standard deviation within sessions over that of the reference (NaN:
%            fewer than four trials beside the means of their sessions, or all alike,
%            which says nothing)
%   P        two-sided, of a ratio as far from 1 where nothing has changed
%
% The trial farthest from the mean of its session is left out: one slip of the hand
% is no scatter. What that does to the logarithm of a standard deviation, and how
% far it errs, 400 draws of normal trials tell; beside it that of the reference
% (log chi-square), and from session to session 0.35 (a factor of 1.4; assumed).

function [ratio, p] = scatterOfChange (values, sessions, repeats, variance, freedom)
  [ratio, p] = deal (NaN);
  n = numel (values);
  [~, ~, of] = unique (sessions);
  of = of(:);
  isAlike = all (abs (values - accumarray (of, values, [], @mean)(of)) <= ...
                 1e-9 * max (abs (values)));
  if n - max ([of; 0]) < 4 || ~(variance > 0) || isAlike
    return
  end
  restore = seedRandom (1);
  drawn = logScatter (randn (n, 400) ./ sqrt (repeats), of, repeats);
  freedom = min (freedom, 1e6);
  % log variance of the reference, as its Student distribution has it
  before = log (variance) - psi (freedom / 2) + log (freedom / 2);
  change = logScatter (values, of, repeats) - mean (drawn) - before / 2;
  sd = sqrt (var (drawn) + psi (1, freedom / 2) / 4 + 2 * 0.35^2);
  ratio = exp (change);
  p = erfc (abs (change) / sd / sqrt (2));
end

% Of each column, without its farthest trial.
function L = logScatter (values, of, repeats)
  [n, m] = size (values);
  many = accumarray (of, repeats);
  far = values - groupSum (repeats .* values, of)(of, :) ./ many(of);
  [~, at] = max (abs (far) .* sqrt (repeats), [], 1);
  kept = ones (n, m);
  kept(at + (0:m - 1) * n) = 0;
  count = groupSum (kept, of);
  weight = repeats .* kept;
  middle = groupSum (weight .* values, of) ./ max (groupSum (weight, of), realmin);
  rest = sum (weight .* (values - middle(of, :)).^2, 1);
  df = sum (max (count - 1, 0), 1);
  L = log (max (rest ./ df, realmin)) / 2;
end

function S = groupSum (values, of)
  S = (of == 1:max (of))' * values;
end

%!test
%! % nine times the scatter is seen, one odd trial is not
%! values = [1; -1; 1; -1; 1; -1; 1; -1];
%! [ratio, p] = scatterOfChange (9 * values, 1 + 0 * values, 1 + 0 * values, 8 / 7, 20);
%! assert (ratio > 8 && ratio < 13);
%! assert (p < 1e-3);
%! values(1) = 30;
%! [ratio, p] = scatterOfChange (values, 1 + 0 * values, 1 + 0 * values, 8 / 7, 20);
%! assert (ratio, 1.2, 0.3);
%! assert (p > 0.5);
%! assert (scatterOfChange ([1; 5; 9], [1; 1; 1], [1; 1; 1], 1, 9), NaN);
%! assert (scatterOfChange (zeros (0, 1), zeros (0, 1), zeros (0, 1), 1, 9), NaN);
%! % the means of sessions are no scatter
%! values = [1; -1; 1; -1; 1; 31; 29; 31; 29; 31];
%! sessions = [1; 1; 1; 1; 1; 2; 2; 2; 2; 2];
%! assert (scatterOfChange (values, sessions, ones (10, 1), 1, 9), 1.2, 0.4);
%!test
%! % means of ten trials each scatter by less; readings that are all alike say nothing
%! values = [1; -1; 1; -1; 1; -1; 1; -1];
%! one = scatterOfChange (9 * values, 1 + 0 * values, 1 + 0 * values, 8 / 7, 20);
%! ten = scatterOfChange (9 * values, 1 + 0 * values, 10 + 0 * values, 8 / 7, 20);
%! assert (ten / one, sqrt (10), 1e-6);
%! assert (scatterOfChange (33 * ones (6, 1), ones (6, 1), ones (6, 1), 1, 9), NaN);
%!test
%! % few trials that nothing has changed: p below 0.05 in 1 to 6 % (seeded; less than
%! % 5 %, as sessions do not differ here)
%! randn ('twister', 5);
%! for i = 1:300
%!   [~, p(i)] = scatterOfChange (randn (6, 1), [1; 1; 1; 2; 2; 2], ones (6, 1), 1, Inf);
%! end
%! assert (mean (p < 0.05) > 0.002 && mean (p < 0.05) < 0.06);
%! % sessions differ: three times the scatter in six trials is no proof
%! for i = 1:100
%!   [ratio(i), p(i)] = scatterOfChange (3 * randn (6, 1), [1; 1; 1; 2; 2; 2], ...
%!                                       ones (6, 1), 1, Inf);
%! end
%! assert (median (ratio), 3, 0.7);
%! assert (mean (p(1:100) < 0.01) < 0.2);

% SPDX-License-Identifier: GPL-3.0-only
