% ALIKETRIALS  How far trials err alike in several quantities.
%
% CALL: [QUANTITIES, ERRORS] = alikeTrials (LINES, QUANTITIES)
%
%   LINES, QUANTITIES  of readingLines; QUANTITIES come back with a smaller share
%                      where what quantities tell is the same
%   ERRORS  1 x Q struct: z (1 x n, the trials of each quantity less the means of their
%           state and session, of norm 1), df (their freedoms) and group (number of
%           those with the same trials; 0: no other has the same)
%
% A trial is one packing, and what it does is in all that is read of it: five readings of
% one heap tell its scatter hardly better than one. Quantities of one model with as many
% lines in each state and session, in the same order, are read of the same trials. As many
% as independent ones tell as much of a variance as M with correlations R: M over
% 1 + (M - 1) R^2, with what R^2 is of independent ones (1 / df) taken out.
%
% See also: varianceComponents, newProblem

function [quantities, errors] = alikeTrials (lines, quantities)
  errors = repmat (struct ('z', zeros (1, 0), 'df', 0, 'group', 0), 1, numel (quantities));
  keys = cell (1, numel (quantities));
  for q = 1:numel (quantities)
    k = find (lines.quantity == q & isnan (lines.variance));
    [cells, ~, of] = unique ([lines.state(k), lines.session(k)], 'rows');
    [errors(q), keys{q}] = errorsOf (lines, k, of, rows (cells), errors(q));
    keys{q} = sprintf ('%d|%s', quantities(q).model, keys{q});
  end
  isSingle = [errors.df] >= 2 & [quantities.share] == 1;
  for key = unique (keys(isSingle))
    same = find (isSingle & strcmp (keys, key{1}));
    if isscalar (same)
      continue
    end
    [errors(same).group] = deal (same(1));
    R = corrOf (vertcat (errors(same).z));
    m = numel (same);
    squares = (sumsq (R(:)) - m) / m / (m - 1);
    own = 1 / errors(same(1)).df;
    alike = max ((squares - own) / (1 - own), 0);
    [quantities(same).share] = deal (1 / (1 + (m - 1) * alike));
  end
end

function [errors, key] = errorsOf (lines, k, of, cells, errors)
  key = sprintf ('%d,%d;', [lines.state(k), lines.session(k)]');
  errors.df = numel (k) - cells;
  if errors.df < 2 || any (lines.repeats(k) ~= 1)
    errors.df = 0;
    return
  end
  means = accumarray (of(:), lines.value(k)) ./ accumarray (of(:), 1);
  z = lines.value(k) - means(of(:));
  errors.z = z' / max (norm (z), realmin);
end

function R = corrOf (Z)
  R = Z * Z';
  R(1:rows (R) + 1:end) = 1;
end

%!function lines = of (Y)
%!  [n, Q] = size (Y);
%!  lines = struct ('value', Y(:), 'quantity', kron ((1:Q)', ones (n, 1)), 'state', ...
%!                  repmat (1 + ((1:n)' > n / 2), Q, 1), 'session', zeros (n * Q, 1), ...
%!                  'repeats', 1, 'variance', NaN (n * Q, 1));
%!  lines.repeats = ones (n * Q, 1);
%!endfunction
%!test
%! % what is read of one packing tells once; what errs by itself, each by itself (seeded)
%! randn ('twister', 1);
%! quantities = repmat (struct ('share', 1, 'model', 1), 1, 4);
%! packing = randn (20, 1);
%! alike = alikeTrials (of (packing + 1e-3 * randn (20, 4)), quantities);
%! assert ([alike.share], 0.25 * ones (1, 4), 0.01);
%! [apart, errors] = alikeTrials (of (randn (20, 4)), quantities);
%! assert (all ([apart.share] > 0.8));
%! assert ([errors.group], ones (1, 4));
%! % another model has other packings, and a curve is told apart already
%! quantities(2).model = quantities(4).model = 2;
%! [quantities(3:4).share] = deal (0.5);
%! [alike, errors] = alikeTrials (of (packing + 1e-3 * randn (20, 4)), quantities);
%! assert ([alike.share], [1, 1, 0.5, 0.5]);
%! assert ([errors.group], zeros (1, 4));

% SPDX-License-Identifier: GPL-3.0-only
