% TRIALSCATTER  Scatter of the trials of one quantity within their sessions.
%
% CALL: [WITHIN, MEANS, COUNTS, DF] = trialScatter (TRIALS)
%
%   TRIALS  1 x n struct of readMeasured, measured lines of one quantity
%   WITHIN  variance of one trial within its session (NaN: not known)
%   MEANS, COUNTS  1 x S, mean and number of trials of each session
%   DF      degrees of freedom of WITHIN (Inf: it was stated)
%
% Of lines with repeats each stands for so many trials (Inf, the sd of which
% holds all scatter: for one).

function [within, means, counts, df] = trialScatter (trials)
  weight = [trials.repeats];
  weight(~isfinite (weight)) = 1;
  value = [trials.value];
  [~, ~, of] = unique ({trials.session});
  of = of(:)';
  counts = accumarray (of', weight)';
  means = accumarray (of', (weight .* value)')' ./ counts;
  df = numel (value) - numel (means);
  within = weight * ((value - means(of)).^2)' / df;
  if df == 0
    sd = [trials.sd];
    isStated = sd > 0;
    within = sum (sd(isStated).^2 .* weight(isStated)) / sum (isStated);
    df = Inf;
  end
end

%!function trials = of (sessions, values)
%!  trials = struct ('session', sessions, 'value', num2cell (values), ...
%!                   'sd', 0, 'repeats', NaN);
%!endfunction
%!test
%! [within, means, counts, df] = trialScatter (of ({'a', 'b', 'a', 'b'}, ...
%!                                                 [1, 5, 3, 7]));
%! assert ({within, means, counts, df}, {2, [2, 6], [2, 2], 2});
%!test
%! trials = of ({'a', 'b'}, [1, 5]);
%! assert (isnan (trialScatter (trials)));
%! [trials.sd] = deal (0.5, 0);
%! trials(1).repeats = 4;
%! [within, ~, counts, df] = trialScatter (trials);
%! assert ({within, counts, df}, {1, [4, 1], Inf});
