% READINGLINES  The lines of all tables as readings of quantities in states.
%
% CALL: [LINES, QUANTITIES, NUMBER, NAMES, AT] = readingLines (LIST, KEYS)
%
%   LIST        1 x n struct of readMeasured, all lines
%   KEYS        1 x n cell, what names the quantity of each line
%   LINES, QUANTITIES  see varianceComponents, those with a value
%   NUMBER      1 x n, mean of each line (0: it has no value)
%   NAMES       1 x S cell, names of the sessions
%   AT          1 x n, element of LINES of each line (0: it has no value)
%
% A state is a condition. Where all of a quantity's lines stand alone in their
% state and session, their sd tells the scatter of a trial: it is that of the mean
% of its repeats, and that of the reference counts for lines without. Where it is that
% of several trials it is known by these (freedom); those of a change that scatter alike
% (25 %, as in varianceComponents) tell it, too. With repeats = Inf it holds all errors,
% that of the session, too, and is known. Beside states whose lines scatter the one line of another
% is as good as the trials that its sd says, and tells their scatter, too, where it is of
% several and alike. Lines without a session, beside others of the quantity with one,
% or where sessionSd says what a session brings, share one of their own. Lines of one block
% (one filling, one packing) of a state and session count as one trial, their mean, known
% as well as the least of them.
% Points of a curve are settings of one group; what drifts, drifts in all of them by
% the same part of their value (withoutDrift).

function [lines, quantities, number, names, at] = readingLines (list, keys)
  [number, at] = deal (zeros (1, numel (list)));
  isThere = isfinite ([list.value]);
  [list, keys] = deal (list(isThere), keys(isThere));
  states = strcat (keys, {'|'}, ofConditions (list));
  [~, ~, state] = unique (states);
  number(isThere) = state;
  weight = ownWeights (list, state);
  [list, first, at(isThere)] = ofBlocks (list, states);
  [keys, state, weight] = deal (keys(first), state(first), weight(first));
  [~, ~, quantity] = unique (keys);
  conditions = ofConditions (list);
  [session, names] = sessionsOf (list, quantity, conditions);
  repeats = [list.repeats]';
  sd = [list.sd]';
  isStated = isinf (repeats) & sd > 0;
  repeats(~isfinite (repeats)) = 1;
  repeats(weight > 0) = weight(weight > 0);
  lines = struct ('value', [list.value]', 'mean', state(:), 'quantity', ...
                  quantity(:), 'session', session, 'repeats', repeats, ...
                  'variance', NaN (numel (list), 1), 'changed', ...
                  ~strcmp (conditions, 'reference')', 'order', ...
                  cellfun (@(one) givenField (one, 'order', NaN), num2cell (list))(:));
  lines.variance(isStated) = sd(isStated).^2;
  quantities = repmat (struct ('unit', 1, 'isContrast', false, 'sessionSd', ...
                               NaN, 'variance', NaN, 'freedom', Inf, 'squares', ...
                               zeros (1, 0), 'share', 1, 'group', 0, 'size', 1), ...
                       1, max ([quantity(:); 0]));
  series = arrayfun (@(one) sprintf ('%d|%s', one.model, one.series), list, ...
                     'UniformOutput', false);
  for q = 1:numel (quantities)
    k = find (quantity(:) == q);
    quantities(q) = quantityOf (list(k), quantities(q));
    quantities(q).share = 1 / pointsOf (list, list(k(1)));
    quantities(q).group = k(1);
    if ~isempty (list(k(1)).series)
      quantities(q).group = find (strcmp (series, series{k(1)}), 1);
      quantities(q).size = mean ([list(k).value]);
    end
    [~, ~, cell_] = unique ([state(k)(:), session(k)], 'rows');
    isAlone = isOnce (cell_);
    isTold = sd(k) > 0 & ~isStated(k);
    isSingle = isTold & isOnce (state(k));
    if all (isAlone) && any (isTold)
      [quantities(q), lines] = statedScatter (quantities(q), lines, k(isTold), sd);
    elseif any (isSingle)
      scatter = scatterWithin (rowsOf (lines, k(~isAlone)), cell_(~isAlone));
      [quantities(q), lines] = besideScatter (quantities(q), lines, k(isSingle), sd, ...
                                              scatter);
    end
  end
end

% n x 1, of how many trials a line is worth in its state, where each of a state in several
% sessions, one of them with several lines, has an sd of its own; 0 elsewhere. These weigh,
% their scatter says how well.
function weight = ownWeights (list, state)
  weight = zeros (numel (list), 1);
  for m = unique (state(:))'
    k = find (state(:)' == m);
    days = numel (unique ({list(k).session}));
    if weighsEach (list(k)) && days > 1 && days < numel (k)
      weight(k) = 1 ./ [list(k).sd].^2;
      weight(k) = weight(k) / mean (weight(k));
    end
  end
end

% n x 1 logical: which numbers stand there once.
function yes = isOnce (number)
  count = accumarray (number(:), 1);
  yes = count(number(:)) == 1;
end

% Variance of a trial about the means of the cells OF, and its freedom.
function s = scatterWithin (lines, of)
  [~, ~, of] = unique (of);
  weight = accumarray (of, lines.repeats);
  middle = accumarray (of, lines.repeats .* lines.value) ./ weight;
  freedom = numel (of) - max (of);
  s = struct ('variance', sum (lines.repeats .* (lines.value - middle(of)).^2) / freedom, ...
              'freedom', freedom);
end

% Lines TOLD stand alone beside others that SCATTER.
function [quantity, lines] = besideScatter (quantity, lines, told, sd, scatter)
  for k = told(:)'
    n = lines.repeats(k);
    own = struct ('variance', sd(k)^2 * n, 'freedom', n - 1);
    if ~(scatter.variance > 0)
      lines.variance(k) = sd(k)^2;
    elseif n > 1 && isAlike (own, scatter)
      quantity.squares = [quantity.squares, repmat(own.variance, 1, round (n - 1))];
    else
      lines.repeats(k) = scatter.variance / sd(k)^2;
    end
  end
end

% Of a trial, by the sd of lines TOLD; of how many trials each is as good as.
function [quantity, lines] = statedScatter (quantity, lines, told, sd)
  variance = sd(told).^2 .* lines.repeats(told);
  freedom = lines.repeats(told) - 1;
  isOwn = ~lines.changed(told);
  isOwn(:) = isOwn | ~any (isOwn);
  isKnown = freedom > 0;                 % of several trials
  if any (isKnown)
    isOwn = isOwn & isKnown;
    isOwn(:) = isOwn | (isKnown & ~any (isOwn));
    [reference, state] = deal (pooled (variance, freedom, isOwn), lines.mean(told));
    for m = unique (state(~isOwn & isKnown))'
      now = pooled (variance, freedom, state == m & isKnown);
      isOwn = isOwn | (state == m & isKnown & isAlike (now, reference));
    end
    all_ = pooled (variance, freedom, isOwn);
    [quantity.variance, quantity.freedom] = deal (all_.variance, all_.freedom);
    told = told(~isOwn);
  else
    quantity.variance = mean (variance(isOwn));
  end
  lines.repeats(told) = quantity.variance ./ sd(told).^2;
end

function s = pooled (variance, freedom, is)
  n = sum (freedom(is));
  s = struct ('variance', sum (freedom(is) .* variance(is)) / n, 'freedom', n);
end

% Two-sided F test at 25 %.
function yes = isAlike (a, b)
  x = a.freedom * a.variance / (a.freedom * a.variance + b.freedom * b.variance);
  p = betainc (x, a.freedom / 2, b.freedom / 2);
  yes = 2 * min (p, 1 - p) >= 0.25;
end

function conditions = ofConditions (list)
  conditions = {list.condition};
  conditions(strcmp (conditions, '')) = {'reference'};
end

% Lines of one block as one, number OF.
function [list, first, of] = ofBlocks (list, states)
  [first, of] = deal (1:numel (list));
  if ~isfield (list, 'block') || all (cellfun (@isempty, {list.block}))
    return
  end
  % a line without a block is one of its own
  block = {list.block};
  isAlone = cellfun (@isempty, block);
  block(isAlone) = arrayfun (@(k) sprintf ('|%d', k), find (isAlone), ...
                             'UniformOutput', false);
  [~, first, of] = unique (strcat (states, {'|'}, {list.session}, {'|'}, block), ...
                           'first');
  for name = intersect (fieldnames (list)', {'value', 'order'})
    means.(name{1}) = num2cell (accumarray (of(:), [list.(name{1})]', [], @mean));
  end
  for name = {'sd', 'repeats'}
    means.(name{1}) = num2cell (accumarray (of(:), [list.(name{1})]', [], @max));
  end
  list = list(first);
  for name = fieldnames (means)'
    [list.(name{1})] = means.(name{1}){:};
  end
end

function [session, names] = sessionsOf (list, quantity, conditions)
  labels = {list.session};
  for q = unique (quantity(:))'
    k = find (quantity(:)' == q);
    isEmpty = cellfun (@isempty, labels(k));
    isKnown = any (isfinite (arrayfun (@(one) givenField (one, 'sessionSd', NaN), list(k))));
    if any (isEmpty) && (isKnown || ~all (isEmpty))
      % no name can hold a bar
      labels(k(isEmpty)) = strcat ('|', conditions(k(isEmpty)));
    end
  end
  % '' sorts first: no session is number 0
  [names, ~, number] = unique ([{''}, labels]);
  names = names(2:end);
  session = number(2:end)(:) - 1;
end

function quantity = quantityOf (list, quantity)
  tol = [list(~isnan ([list.tol])).tol];
  middle = abs (mean ([list.value]));
  quantity.unit = middle;
  if ~isempty (tol) && any ([list.isAbsolute])
    quantity.unit = tol(1);
  elseif ~isempty (tol)
    quantity.unit = tol(1) * middle;
  end
  if ~(quantity.unit > 0)
    quantity.unit = 1;
  end
  quantity.isContrast = any (givenField (list(1), 'isContrast', false));
  if isfield (list, 'sessionSd')
    given = [list.sessionSd];
    given = given(isfinite (given));
    if ~isempty (given)
      quantity.sessionSd = mean (given);
    end
  end
end

% On how many places a curve was read.
function n = pointsOf (list, one)
  n = 1;
  if ~isempty (one.series)
    isOn = [list.model] == one.model & strcmp ({list.series}, one.series);
    n = numel (unique ([list(isOn).at]));
  end
end

%!function list = of (sessions, values, sds)
%!  list = struct ('session', sessions, 'value', num2cell (values), 'sd', ...
%!                 num2cell (sds), 'repeats', NaN, 'condition', '', 'model', 1, ...
%!                 'name', 'a', 'series', '', 'at', NaN, 'tol', NaN, ...
%!                 'isAbsolute', false);
%!endfunction
%!test
%! % trials; one line a state, of which the sd is what is known; one a session
%! [lines, q, number] = readingLines (of ({'', ''}, [1, 3], [0.1, 0.1]), {'a', 'a'});
%! assert ({lines.session, lines.variance, number}, {[0; 0], [NaN; NaN], [1, 1]});
%! assert ({q.unit, q.variance, q.freedom}, {2, NaN, Inf});
%! list = of ({'', ''}, [1, 3], [0.1, 0]);
%! list(1).repeats = 4;
%! list(2).condition = 'moist';
%! [lines, q] = readingLines (list, {'a', 'a'});
%! assert ({lines.mean, lines.repeats}, {[2; 1], [4; 1]}, 1e-12);
%! assert ({q.variance, q.freedom, lines.changed}, {0.04, 3, [false; true]}, 1e-12);
%! list(2).sd = 0.4;
%! [lines, q] = readingLines (list, {'a', 'a'});
%! assert ({q.variance, lines.repeats}, {0.04, [4; 0.25]}, 1e-12);
%! list(2).sd = 0;
%! % four trials before and after: one scatter, of six freedoms, if it is alike
%! list(2).repeats = 4;
%! list(2).sd = 0.15;
%! [lines, q] = readingLines (list, {'a', 'a'});
%! assert ({q.variance, q.freedom, lines.repeats}, {0.065, 6, [4; 4]}, 1e-12);
%! list(2).sd = 1;
%! [lines, q] = readingLines (list, {'a', 'a'});
%! assert ({q.variance, q.freedom, lines.repeats}, {0.04, 3, [4; 0.04]}, 1e-12);
%! list(2).repeats = NaN;
%! list(2).sd = 0;
%! [list.session] = deal ('mon', '');
%! list(1).repeats = NaN;
%! [lines, q, ~, names] = readingLines (list, {'a', 'a'});
%! assert ({names, lines.session}, {{'mon', '|moist'}, [1; 2]});
%! assert ({lines.variance, q.variance}, {[NaN; NaN], 0.01}, 1e-12);
%!test
%! % two readings of each of three fillings are three trials
%! list = of (repmat ({''}, 1, 6), [1, 3, 5, 7, 6, 6], zeros (1, 6));
%! [list.block] = deal ('x', 'x', 'y', 'y', 'z', 'z');
%! lines = readingLines (list, repmat ({'a'}, 1, 6));
%! assert ({lines.value, lines.repeats}, {[2; 6; 6], [1; 1; 1]});

% SPDX-License-Identifier: GPL-3.0-only
