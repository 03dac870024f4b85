% VARIANCECOMPONENTS  Means of readings, and how well they are known.
%
% CALL: [MEANS, RATIO] = varianceComponents (LINES, QUANTITIES)
%
%   LINES       struct of n x 1 arrays, of readingLines: value, mean (1 ... M, of
%               which quantity and state), quantity (1 ... Q), session (1 ... S,
%               0: none), repeats, variance (NaN: to be found; else that of the
%               value, with all that it holds), changed (logical)
%   QUANTITIES  1 x Q struct: unit (of its scatter), isContrast, sessionSd (NaN: to
%               be found), variance (of one trial, NaN: to be found) and the freedom
%               (Inf) by which it is known, squares (1 x m, further contrasts of trials,
%               told by an sd), share (of a quantity in what is learned of
%               sessions)
%   MEANS       1 x M struct: value, sd (0: nothing tells it), shared (part of sd
%               that sessions make), days (1 x S, what each session brings to
%               it, norm SHARED), freedom (by which the quantity's own scatter is
%               known), commonFreedom and sessionFreedom (by which what quantities
%               have in common is, of the part without sessions and of SHARED),
%               hasScatter (logical: sd was found from lines that scatter), of a
%               change scatterRatio and scatterP (see scatterOfChange; NaN), swept
%               (false, see withoutDrift)
%   RATIO       1 x 2 struct, of levels and of contrasts: value (standard
%               deviation between sessions over that of a trial within one,
%               geometric mean), df (contrasts between sessions that told it)
%
% A line is y = mean (quantity, state) + session + trial, the standard deviations
% of session and trial R s and s. Means are eliminated (restricted likelihood:
% Patterson and Thompson 1971): contrasts u with the variances s^2 (1 + R^2
% lambda). s^2 of a quantity is scaled inverse chi-square about a variance that
% quantities have in common in their units, with freedoms that the quantities tell
% (Smyth 2004), or, 1 in 20 beforehand, like no other (a fine balance beside coarse
% readings), anywhere in eight decades; R is one of all levels, and one of all contrasts
% within a session (a ratio of two settings). Their posterior is summed over a grid.
%
% Prior of R: log-normal, deviation 0.7, about 2.5 for a level: four measured
% rigs on which nothing was changed show 2 to 3; about 0.7 for a contrast, in
% which most of a session cancels: three powders in one doser show 0.5 to 1.
%
% Where nothing has changed, trials of a change scatter as those of the reference do, and
% tell their scatter, too (the pooled variance of Student's test, which of means of
% equally many trials holds where their scatter differs, too). What seems to scatter in
% its own way (scatterOfChange, 25 %: Bancroft 1964) tells nothing of it: it enters as the
% means of its sessions, and if it surely scatters more (1 %), its mean is that much less
% certain.
%
% Of the sum of both errors the distribution is a mixture; SD is its 68 %
% half-width. The freedoms are those of the Student distributions that doubt a
% variance as much (variance of its logarithm): given the common variance and the
% ratio, and of these.

function [means, ratio] = varianceComponents (lines, quantities)
  Q = numel (quantities);
  days = max ([lines.session; 0]);
  means = repmat (struct ('value', NaN, 'sd', 0, 'shared', 0, ...
                          'days', zeros (1, days), 'freedom', Inf, ...
                          'commonFreedom', Inf, 'sessionFreedom', Inf, ...
                          'hasScatter', false, 'scatterRatio', NaN, ...
                          'scatterP', NaN, 'swept', false), ...
                  1, max ([lines.mean; 0]));
  ratio = struct ('value', {2.5, 0.7}, 'df', 0);
  if Q == 0
    return
  end
  lines.apart = lines.changed;
  [alone, found] = estimated (lines, quantities, means, ratio);
  p = [alone.scatterP];
  lines.apart = lines.changed & p(lines.mean)(:) < 0.25;
  if isequal (lines.apart, lines.changed)
    [means, ratio] = deal (alone, found);
    return
  end
  [means.scatterRatio] = deal (alone.scatterRatio);
  [means.scatterP] = deal (alone.scatterP);
  [means, ratio] = estimated (lines, quantities, means, ratio);
end

% With what is apart as the means of its sessions.
function [means, ratio] = estimated (lines, quantities, means, ratio)
  of = accumarray (lines.quantity, 1:numel (lines.value), ...
                   [numel(quantities), 1], @(k) {sort(k)});
  parts = cellfun (@(k, q) contrastsOf (rowsOf (lines, k), q), of', ...
                   num2cell (quantities));
  for kind = 1:2
    mine = find ([quantities.isContrast] == kind - 1);
    grid = posteriorOf (parts(mine), quantities(mine), ratio(kind).value);
    ratio(kind).value = exp (grid.ofRatio * log (grid.ratio'));
    for q = mine
      ratio(kind).df = ratio(kind).df + ...
                       quantities(q).share * sum (parts(q).lambda > 0);
      scatter = scatterOf (grid, parts(q), quantities(q));
      own = rowsOf (lines, of{q});
      scatter.usual = usualVariance (own, scatter);
      for m = unique (own.mean)'
        means(m) = meanOf (rowsOf (own, own.mean == m), scatter, ...
                           quantities(q), means(m));
        means(m).hasScatter = isnan (quantities(q).variance) && ...
                              any (scatter.scale > 0) && ...
                              ~all (isfinite (own.variance(own.mean == m)));
      end
    end
  end
end

% Contrasts of one quantity, free of its means: their squares and lambda, sorted.
function part = contrastsOf (lines, quantity)
  part = contrastsOfLines (lines, quantity);
  told = givenField (quantity, 'squares', []) / quantity.unit^2;
  part.squares = [part.squares, told];
  part.lambda = [part.lambda, 0 * told];
end

function part = contrastsOfLines (lines, quantity)
  part = struct ('squares', zeros (1, 0), 'lambda', zeros (1, 0));
  lines = rowsOf (lines, isnan (lines.variance));
  lines = withoutApart (lines);
  n = numel (lines.value);
  if n < 2
    return
  end
  root = sqrt (lines.repeats);
  X = root .* (lines.mean == unique (lines.mean)');
  Z = root .* (lines.session == setdiff (lines.session, 0)');
  N = null (X');
  B = N' * (Z * Z') * N;
  [U, L] = eig ((B + B') / 2);
  u = U' * N' * (root .* lines.value) / quantity.unit;
  part.lambda = diag (L)';
  part.lambda(part.lambda < 1e-9 * max (lines.repeats)) = 0;
  part.squares = (u.^2)';
  if ~any (part.squares > 1e-18 * (mean (abs (lines.value)) / quantity.unit)^2)
    % readings that are alike to the last digit say nothing of their scatter
    part = struct ('squares', zeros (1, 0), 'lambda', zeros (1, 0));
    return
  end
  if ~isnan (quantity.sessionSd)
    kept = part.lambda == 0;
    part = struct ('squares', part.squares(kept), 'lambda', ...
                   part.lambda(kept));
  end
end

% Trials that are apart as the means of their sessions, if the others tell how trials
% scatter.
function lines = withoutApart (lines)
  others = [lines.mean(~lines.apart), lines.session(~lines.apart)];
  if rows (unique (others, 'rows')) == rows (others)
    return
  end
  [~, first, cell_] = unique ([lines.mean, lines.session, ...
                               (1:numel (lines.value))' .* ~lines.apart], ...
                              'rows');
  lines.value = accumarray (cell_, lines.value .* lines.repeats) ./ ...
                accumarray (cell_, lines.repeats);
  repeats = accumarray (cell_, lines.repeats);
  for name = {'mean', 'session'}
    lines.(name{1}) = lines.(name{1})(first);
  end
  lines.repeats = repeats;
end

% Ratio, common variance and freedoms about it: weights over a grid, R x D x S.
function grid = posteriorOf (parts, quantities, middle)
  grid.ratio = exp (linspace (log (middle) - 3.5, log (middle) + 3.5, 71));
  grid.logPrior = -0.5 * (log (grid.ratio / middle) / 0.7).^2';
  isOpen = isnan ([quantities.variance]) & cellfun (@numel, {parts.squares}) > 0;
  [grid.freedom, grid.common] = deal (1, 1);
  if any (isOpen)
    grid.freedom = [1, 2, 4, 8, 16, 32];
    squares = [parts(isOpen).squares];
    middle = log (median (squares(squares > 0)));
    grid.common = exp (linspace (middle - 10, middle + 10, 41));
  end
  grid = weighed (grid, parts, quantities);
  if any (isOpen)
    % finer where the weight is
    w = reshape (sum (sum (grid.weight, 1), 2), 1, []);
    x = log (grid.common);
    m = w * x';
    s = sqrt (w * (x - m)'.^2 + 0.5^2 / 12);
    grid.common = exp (linspace (m - 4 * s, m + 4 * s, 33));
    grid = weighed (grid, parts, quantities);
  end
  grid.ofRatio = sum (sum (grid.weight, 2), 3)';
end

function grid = weighed (grid, parts, quantities)
  logP = grid.logPrior + zeros (1, numel (grid.freedom), numel (grid.common));
  for q = 1:numel (parts)
    known = quantities(q).variance / quantities(q).unit^2;
    [rest, logDet] = restOf (grid, parts(q));
    if ~isnan (known)
      logL = -logDet - rest / known / 2;
    else
      logL = openLikelihood (grid, parts(q)) - logDet;
    end
    % of a curve what sessions do is seen at every point
    share = quantities(q).share;
    logP = logP + share * logL;
  end
  grid.weight = exp (logP - max (logP(:)));
  grid.weight = grid.weight / sum (grid.weight(:));
end

% Of a scatter to be found, and the share of it by which it is like no other: what
% fewer than three contrasts leave next to nothing may do so by chance, or by rounding.
function [logL, apart] = openLikelihood (grid, part)
  [d, common] = priorOf (grid);
  df = numel (part.lambda);
  rest = restOf (grid, part);
  logL = d / 2 .* log (d .* common) - (d + df) / 2 .* log (d .* common + rest) + ...
         gammaln ((d + df) / 2) - gammaln (d / 2);
  apart = 0;
  if df > 2
    own = log (0.05 / 18) + gammaln (df / 2) - df / 2 * log (rest);
    apart = 1 ./ (1 + exp (logL - own));
    logL = max (logL, own) + log1p (exp (-abs (logL - own)));
  end
end

function [d, common] = priorOf (grid)
  d = reshape (grid.freedom, 1, []);
  common = reshape (grid.common, 1, 1, []);
end

% Sum of squares that the ratio leaves to a trial, R x 1, and half the logarithm
% of the determinant.
function [rest, logDet] = restOf (grid, part)
  ratio = grid.ratio';
  if ~any (part.lambda)
    ratio = ratio(1);
  end
  each = 1 + ratio.^2 * part.lambda;
  rest = sum (part.squares ./ each, 2);
  logDet = sum (log (each), 2) / 2;
end

% What is known of the variance of a trial of one quantity: for each ratio its
% scale (0: nothing) and freedom; freedoms own, common, of sessions, see above.
function scatter = scatterOf (grid, part, quantity)
  R = numel (grid.ratio);
  scatter = struct ('ratio', grid.ratio, 'weight', grid.ofRatio, ...
                    'scale', zeros (1, R), 'freedom', Inf (1, R), ...
                    'own', Inf, 'common', Inf, 'session', Inf);
  middle = zeros (R, 1);
  common = grid.ofRatio';
  if ~isnan (quantity.variance)
    scatter.scale(:) = quantity.variance;
    [scatter.own, scatter.freedom(:)] = deal (quantity.freedom);
  elseif ~isempty (part.lambda)
    [d, s] = priorOf (grid);
    nu = d + numel (part.lambda);
    each = log ((d .* s + restOf (grid, part)) / 2) - psi (nu / 2) + ...
           zeros (R, 1);
    spread = psi (1, nu / 2) + 0 * each;
    [each, spread] = withApart (each, spread, grid, part);
    [first, second] = momentsOver (grid.weight, each, spread, [2, 3]);
    [scale, freedom] = studentOf (first, second);
    scatter.scale = scale' * quantity.unit^2;
    scatter.freedom = freedom';
    % given the common variance and the ratio, and what these leave open
    [middle, second] = momentsOver (grid.weight, each, spread, 2);
    common = sum (grid.weight, 2);
    [~, scatter.own] = studentOf (0, sum (sum (common .* second)));
    scatter.common = freedomFrom (common, middle);
  end
  scatter.session = freedomFrom (common, middle + 2 * log (grid.ratio'));
end

% The logarithm of the variance, mean and variance, also where it is like no other.
function [each, spread] = withApart (each, spread, grid, part)
  [~, apart] = openLikelihood (grid, part);
  if any (apart(:))
    df = numel (part.lambda);
    off = log (restOf (grid, part) / 2) - psi (df / 2) - each;
    spread = spread + apart .* (psi (1, df / 2) - spread) + apart .* (1 - apart) .* off.^2;
    each = each + apart .* off;
  end
end

% Mean and variance of a mixture over some dimensions of the grid.
function [first, second] = momentsOver (weight, middle, spread, dims)
  over = @(x) x;
  for k = dims
    over = @(x) sum (over (x), k);
  end
  share = weight ./ max (over (weight), realmin);
  first = over (share .* middle);
  second = over (share .* (spread + (middle - first).^2));
  second(over (weight) < 1e-12) = 1;
end

function freedom = freedomFrom (weight, middle)
  m = sum (weight(:) .* middle(:));
  [~, freedom] = studentOf (m, sum (weight(:) .* (middle(:) - m).^2));
end

% The Student distribution whose squared scale is as doubtful: mean and variance of
% its logarithm.
function [scale, freedom] = studentOf (middle, spread)
  spread = max (spread, 1e-6);
  % trigamma (y) = spread by Newton's method on 1 / trigamma (Smyth 2004)
  y = 0.5 + 1 ./ spread;
  for k = 1:20
    t = psi (1, y);
    y = y + t .* (1 - t ./ spread) ./ psi (2, y);
  end
  freedom = 2 * y;
  scale = exp (middle + psi (y) - log (y));
end

% One mean: its lines, and what is known of the scatter of its quantity.
function found = meanOf (lines, scatter, quantity, found)
  [factor, found] = factorOfChange (lines, scatter, quantity, found);
  isStated = ~isnan (lines.variance);
  ofSession = lines.session > 0 & ~isStated;
  isKnown = ~isnan (quantity.sessionSd);
  % without any scatter all lines count alike, and far more than one that is stated
  least = max ([1e-12 * lines.variance(isStated); sqrt(realmin)]);
  sigma2 = max (scatter.weight * scatter.scale', least);
  between = sigma2 * (scatter.weight * scatter.ratio'.^2);
  if isKnown
    between = quantity.sessionSd^2;
  end
  within = factor * sigma2 ./ lines.repeats;
  within(isStated) = lines.variance(isStated);
  w = bestWeights (diag (within) + between * ...
                   (lines.session' == lines.session & (ofSession & ofSession')));
  found.value = w' * lines.value;
  days = zeros (size (found.days));
  for k = find (ofSession)'
    days(lines.session(k)) = days(lines.session(k)) + w(k);
  end
  known = sum (w(isStated).^2 .* lines.variance(isStated));
  own = factor * sum (w.^2 ./ lines.repeats .* ~isStated);
  found = withErrors (found, scatter, own, (days * days') * ~isKnown, known);
  if isKnown
    found.shared = quantity.sessionSd * norm (days);
    found.sd = hypot (found.sd, found.shared);
  end
  found.days = days * found.shared / max (norm (days), realmin);
end

% Of least variance, sum 1; C by its correlations, as its units may be any.
function w = bestWeights (C)
  root = sqrt (diag (C));
  w = sum (inv (C ./ (root * root')) ./ (root * root'), 2);
  w = w / sum (w);
end

% Of a trial of the reference: without the farthest one, where this alone makes it large.
function variance = usualVariance (lines, scatter)
  variance = scatter.weight * scatter.scale';
  at = ~lines.changed & isnan (lines.variance);
  [ratio, p] = scatterOfChange (lines.value(at), lines.session(at), lines.repeats(at), ...
                                variance, Inf);
  if ratio < 1 && p < 0.01
    variance = variance * ratio^2;
  end
end

% By what the variance of a trial is larger in a change, as far as that is sure.
function [factor, found] = factorOfChange (lines, scatter, quantity, found)
  factor = 1;
  trials = isnan (lines.variance);
  if ~all (lines.changed) || ~isnan (quantity.variance)
    return
  end
  if isnan (found.scatterP)
    [found.scatterRatio, found.scatterP] = ...
      scatterOfChange (lines.value(trials), lines.session(trials), ...
                       lines.repeats(trials), scatter.usual, ...
                       1 / (1 / scatter.own + 1 / scatter.common));
  end
  if found.scatterRatio > 1 && found.scatterP < 0.01
    factor = found.scatterRatio^2;
  end
end

% Errors of OWN and BETWEEN times the variance of a trial, the latter times the
% square of the ratio, and of a KNOWN variance.
function found = withErrors (found, scatter, own, between, known)
  factor = own + between * scatter.ratio.^2;
  [sd, share] = deal (0);
  if any (factor > 0) && any (scatter.scale > 0)
    sd = halfWidth (sqrt (factor .* scatter.scale), scatter.freedom, ...
                    scatter.weight);
    % what trials alone make, which is left of a difference of the same days
    trials = halfWidth (sqrt (own .* scatter.scale), scatter.freedom, ...
                        scatter.weight);
    share = max (1 - (trials / sd)^2, 0);
    % Welch and Satterthwaite: a part that is known doubts nothing
    less = [sd^2 + known, sd^2 * (1 - share) + known] ./ ...
           max (sd^2 * [1, 1 - share], realmin);
    found.freedom = scatter.own * less(1)^2;
    found.commonFreedom = scatter.common * less(2)^2;
    if between > 0
      found.sessionFreedom = scatter.session;
    end
  end
  found.shared = sd * sqrt (share);
  found.sd = hypot (sd, sqrt (known));
end

% Within which 68 % of a mixture of Student distributions lie.
function h = halfWidth (scale, freedom, weight)
  used = weight > 1e-6 * max (weight);
  [scale, freedom] = deal (scale(used), min (freedom(used), 1e7));
  weight = weight(used) / sum (weight(used));
  [lo, hi] = deal (0.5 * min (scale), 100 * max (scale));
  for k = 1:40
    h = sqrt (lo * hi);
    % Student's tail as a normal one (Wallace 1959), within a hundredth
    z = (8 * freedom + 1) ./ (8 * freedom + 3) .* ...
        sqrt (freedom .* log1p ((h ./ scale).^2 ./ freedom));
    if weight * erfc (z / sqrt (2))' > 0.3173
      lo = h;
    else
      hi = h;
    end
  end
end

%!function lines = of (values, sessions, state)
%!  n = numel (values);
%!  lines = struct ('value', values(:), 'mean', state(:), 'quantity', ...
%!                  ones (n, 1), 'session', sessions(:), 'repeats', ...
%!                  ones (n, 1), 'variance', NaN (n, 1), 'changed', ...
%!                  state(:) > 1);
%!endfunction
%!shared quantity
%! quantity = struct ('unit', 1, 'isContrast', false, 'sessionSd', NaN, ...
%!                    'variance', NaN, 'freedom', Inf, 'share', 1);
%!test
%! % one quantity, three trials, no session: t s / sqrt (n), two degrees of freedom
%! m = varianceComponents (of ([1, 2, 3], [0, 0, 0], [1, 1, 1]), quantity);
%! assert ([m.value, m.shared], [2, 0], 1e-12);
%! assert (m.sd, 1.32 / sqrt (3), 0.02);
%! m = varianceComponents (of ([1, 3], [0, 0], [1, 1]), quantity);
%! assert (m.sd, 1.84, 0.2);
%! assert (1 / (1 / m.freedom + 1 / m.commonFreedom), 1, 0.3);
%!test
%! % the same days: what they bring is in both; a state read once is as uncertain as
%! % a trial; a change of sessions that are known
%! values = [10, 11, 14, 15, 12, 16, 30];
%! lines = of (values, [1, 1, 2, 2, 1, 2, 3], [1, 1, 1, 1, 2, 2, 3]);
%! m = varianceComponents (lines, quantity);
%! assert ([m(1:2).value], [12.5, 14], 1e-9);
%! assert (m(1).days, m(2).days, 0.2 * m(1).shared);
%! assert (m(3).sd > m(2).sd);
%! assert (m(1).days * m(3).days', 0);
%! known = setfield (quantity, 'sessionSd', 2);
%! m = varianceComponents (lines, known);
%! assert (m(3).days, [0, 0, 2], 1e-9);
%! assert ([m.sessionFreedom], [Inf, Inf, Inf]);
%!test
%! % readings lean on each other: of twelve with two trials one that hardly scatters
%! % is not believed (seeded)
%! randn ('twister', 3);
%! values = [randn(2, 11), [0; 1e-3]];
%! lines = of (values, zeros (1, 24), kron (1:12, [1, 1]));
%! lines.quantity = lines.mean;
%! lines.changed(:) = false;
%! m = varianceComponents (lines, repmat (quantity, 1, 12));
%! assert (m(12).sd > 0.1 && m(12).sd < 1);
%! assert (m(12).commonFreedom > 5);
%! % with three before and after one that scatters by a hundredth of the five others is (seeded)
%! randn ('twister', 3);
%! values = kron ([1e-2, 1, 1, 1, 1, 1], [1, 1]) .* randn (3, 12);
%! lines = of (values, zeros (1, 36), kron (1:12, ones (1, 3)));
%! lines.quantity = ceil (lines.mean / 2);
%! lines.changed = mod (lines.mean, 2) == 0;
%! m = varianceComponents (lines, repmat (quantity, 1, 6));
%! assert (sdOfChange (m(1), m(2)) < 0.03);
%!test
%! % what is stated with all its errors stays as it is, of a session or not
%! lines = of ([1, 3], [1, 2], [1, 2]);
%! lines.variance = [0.01; 0.04];
%! m = varianceComponents (lines, quantity);
%! assert ([m.sd; m.shared], [0.1, 0.2; 0, 0], 1e-12);
%! assert ([m.freedom, m.sessionFreedom], Inf (1, 4));
%!test
%! % a scatter that was stated of few trials is known by these alone
%! lines = of ([1, 3], [0, 0], [1, 2]);
%! lines.repeats(:) = 3;
%! stated = mergeFields (quantity, struct ('variance', 0.3, 'freedom', 4));
%! m = varianceComponents (lines, stated);
%! assert ([m.sd], sqrt (0.1) * studentFactor (4) * [1, 1], 0.01);
%! assert ([m.freedom], [4, 4]);
%! assert ([m.hasScatter], [false, false]);
%!test
%! % three trials before and three after tell their scatter together, as in Student's
%! % test; where the change scatters nine times more, only the reference is believed
%! lines = of ([19.8, 18.1, 19.4, 28.1, 32.9, 28.3], zeros (1, 6), [1, 1, 1, 2, 2, 2]);
%! m = varianceComponents (lines, quantity);
%! [sd, freedom] = sdOfChange (m(1), m(2));
%! pooled = sqrt ((sumsq ([19.8, 18.1, 19.4] - 19.1) + ...
%!                 sumsq ([28.1, 32.9, 28.3] - 89.3 / 3)) / 4 * 2 / 3);
%! assert (sd / studentFactor (freedom), pooled, 0.15 * pooled);
%! assert (freedom > 3);
%! wild = [1; -1; 1; -1; 1; -1; 1; -1];
%! lines = of ([wild; 9 * wild], zeros (1, 16), kron ([1, 2], ones (1, 8)));
%! m = varianceComponents (lines, quantity);
%! assert (m(1).sd, sqrt (8 / 7 / 8), 0.1);
%! assert (m(2).scatterP < 0.05);
%!test
%! % one odd trial, before or after, is no other scatter
%! calm = 31 + 0.1 * [1, -1, 2, 0, -2];
%! odd = [calm(1:4), 45];
%! for pair = {calm, odd; odd, calm}
%!   lines = of ([pair{:}], zeros (1, 10), kron ([1, 2], ones (1, 5)));
%!   assert (varianceComponents (lines, quantity)(2).scatterP > 0.05);
%! end
%!test
%! % what a session brings is known, the scatter of a trial is not
%! m = varianceComponents (of ([31, 33], [1, 2], [1, 2]), setfield (quantity, 'sessionSd', 1));
%! assert ({[m.sd], [m.hasScatter]}, {[1, 1], [false, false]}, 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
