% GAPREFERENCE  Draws what the gate's statistic is where there is no gap.
%
% CALL: HYPOTHESES = gapReference (HYPOTHESES)
% CALL: HYPOTHESES = gapReference (HYPOTHESES, STATISTIC [, LEVELS])
%
%   HYPOTHESES  struct of makeHypotheses; options.twins data sets are drawn from
%              the null model, parameters by their prior, and fitted like the
%              measurement
%   STATISTIC  scalar, of the measurement: after every hundred data sets no more
%              are drawn if they leave no doubt (1 %) on which side of
%              each of LEVELS (options.significance) its p is
%   HYPOTHESES     the same with reference, a column
%
% Surrogates err in ways that they do not know: the drawn data scatter with
% options.surplus times the variance, see gapOptions.

function hypotheses = gapReference (hypotheses, statistic, levels)
  if nargin < 3
    levels = hypotheses.options.significance;
  end
  most = hypotheses.options.twins;
  n = most;
  if nargin > 1
    % most cases are far from the level, and known after the first hundred
    n = 100;
  end
  hypotheses.reference = zeros (0, 1);
  while rows (hypotheses.reference) < most
    m = min (n, most - rows (hypotheses.reference));
    seed = hypotheses.options.seed + 500 + rows (hypotheses.reference);
    Y = drawTwins (hypotheses, m, seed, hypotheses.options.surplus);
    fits = fitLibrary (hypotheses, Y);
    hypotheses.reference = [hypotheses.reference; ...
                            gapTest(hypotheses, fits.logE).statistic];
    if nargin > 1 && ...
       all (arrayfun (@(level) isClear (hypotheses.reference >= statistic, level), levels))
      return
    end
  end
end

% As many, or as few, would reach it in less than 1 % if p were the significance.
function yes = isClear (reached, significance)
  n = numel (reached);
  k = sum (reached);
  atLeast = 1;
  if k > 0
    atLeast = betainc (significance, k, n - k + 1);
  end
  atMost = 1;
  if k < n
    atMost = 1 - betainc (significance, k + 1, n - k);
  end
  yes = min (atLeast, atMost) < 0.01;
end

%!test
%! % the level is held: data sets without a gap of another seed alarm in 5 %
%! % (binomial, 200 draws and a reference of 400: chance of failing below 1 %)
%! hypotheses = handMadeHypotheses ();
%! hypotheses.options.surplus = 1;
%! hypotheses = gapReference (hypotheses);
%! Y = drawTwins (hypotheses, 200, 77);
%! p = gapTest (hypotheses, fitLibrary (hypotheses, Y).logE).p;
%! assert (mean (p < 0.05) > 0.005 && mean (p < 0.05) < 0.11);
%!test
%! % no doubt after a hundred: none of them, or many, reach it
%! hypotheses = handMadeHypotheses ();
%! assert (rows (gapReference (hypotheses, 1e3).reference), 100);
%! assert (rows (gapReference (hypotheses, -1e3).reference), 100);
%! values = gapReference (hypotheses).reference;
%! near = sort (values)(round (0.95 * numel (values)));
%! assert (rows (gapReference (hypotheses, near).reference) > 100);
%! % one level may leave a doubt where another one does not
%! assert (rows (gapReference (hypotheses, near, [1e-9, 0.05]).reference) > 100);

% SPDX-License-Identifier: GPL-3.0-only
