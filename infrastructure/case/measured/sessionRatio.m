% SESSIONRATIO  How much sessions differ, as multiples of the scatter within one.
%
% CALL: SESSIONS = sessionRatio (LIST)
%
%   LIST      1 x n struct of readMeasured, all lines
%   SESSIONS  struct: given (logical: LIST has sessions), names (cell, those of
%             the reference), ratio (standard deviation between sessions over
%             that of a trial within one; 0 where none are given), df (degrees
%             of freedom that told it; 0: it is what other rigs show)
%
% Every quantity that was measured in several sessions gives
%   ratio^2 = (F - 1) / n0,  F = n0 (variance of the means) / (that within),
% n0 the trials in a session (analysis of variance, as far as its mean exists:
% F (df - 2) / df). They are averaged with the prior, 2.5 at two degrees of
% freedom: four measured rigs on which nothing was changed give 2 to 3. A curve
% counts as one quantity.

function sessions = sessionRatio (list)
  sessions = struct ('given', false, 'names', {{}}, 'ratio', 0, 'df', 0);
  if ~isempty (list)
    list = list(isfinite ([list.value]));
  end
  if isempty (list) || all (cellfun (@isempty, {list.session}))
    return
  end
  isReference = ismember ({list.condition}, {'', 'reference'});
  sessions.given = true;
  sessions.names = unique ({list(isReference).session}, 'stable');
  sum2 = 2 * 2.5^2;
  keys = arrayfun (@(o) sprintf ('%s|%d|%s|%s', o.condition, o.model, ...
                                 o.name, o.series), list, ...
                   'UniformOutput', false);
  [~, ~, quantity] = unique (keys);
  for k = 1:max (quantity)
    [squares, weights] = ofQuantity (list(quantity == k));
    if ~isempty (squares)
      sessions.df = sessions.df + mean (weights);
      sum2 = sum2 + mean (weights .* squares);
    end
  end
  sessions.ratio = sqrt (max (sum2 / (2 + sessions.df), 0));
end

% Of each of its places with several sessions: ratio^2, and degrees of freedom.
function [squares, weights] = ofQuantity (list)
  [squares, weights] = deal (zeros (1, 0));
  places = [list.at];
  places(isnan (places)) = Inf;
  for at = unique (places)
    [within, means, counts, df] = trialScatter (list(places == at));
    n = numel (means);
    if n > 1 && within > 0
      total = sum (counts);
      each = (total - sumsq (counts) / total) / (n - 1);
      m = means * counts' / total;
      F = counts * ((means - m).^2)' / (n - 1) / within;
      if isfinite (df)
        F = F * max (df - 2, 0.5) / df;
      end
      squares(end + 1) = (F - 1) / each;
      weights(end + 1) = n - 1;
    end
  end
end

%!function list = of (sessions, values, condition)
%!  list = struct ('session', sessions, 'value', num2cell (values), 'sd', 0, ...
%!                 'repeats', NaN, 'condition', condition, 'model', 1, ...
%!                 'name', 'a', 'series', '', 'at', NaN);
%!endfunction
%!test
%! % no session, one session: what other rigs show
%! assert (sessionRatio (of ({'', ''}, [1, 2], '')).given, false);
%! s = sessionRatio (of ({'mon', 'mon'}, [1, 2], ''));
%! assert ({s.given, s.names, s.ratio, s.df}, {true, {'mon'}, 2.5, 0});
%!test
%! % 40 quantities in four sessions of four trials, with the ratio 1. Over seeds
%! % the estimate is 1.06 with a standard deviation of 0.08 (chance to fail: 2 %)
%! randn ('twister', 4);
%! list = [];
%! for k = 1:40
%!   b = repmat (randn (1, 4), 4, 1);
%!   own = of (repmat ({'a', 'b', 'c', 'd'}, 4, 1)(:)', ...
%!             b(:)' + randn (1, 16), 'reference');
%!   [own.name] = deal (sprintf ('q%d', k));
%!   list = [list, own];
%! end
%! s = sessionRatio (list);
%! assert (s.ratio, 1, 0.25);
%! assert (s.df, 120);
%! % a curve counts once
%! [list.name] = deal ('');
%! at = num2cell (kron (1:40, ones (1, 16)));
%! [list.at] = at{:};
%! [list.series] = deal ('w');
%! assert (sessionRatio (list).df, 3, 1e-9);
