% COSTTEXTS  What is said of the best set known, where a cost is all there is.
%
% CALL: TEXTS = costTexts (B)
%
%   B      see bestKnown
%   TEXTS  1 x n cell of sentences

function texts = costTexts (b)
  texts = {['There is no interval, no probability and no diagnosis: one number a ' ...
            'run does not tell which result misses, nor how runs scatter.']};
  if b.runs > 1
    texts{end + 1} = sprintf ('The cost is the mean of %d runs.', b.runs);
  else
    texts{end + 1} = ['It is the luckiest of one run a set: run these values again ' ...
                      'with another packing.'];
  end
  if b.failed + b.outside > 0
    texts{end + 1} = sprintf ('Not counted: %s without a cost, %s beyond the limits.', ...
                              countText (b.failed, 'row'), countText (b.outside, 'set'));
  end
  texts{end + 1} = ['To know more, put the results that the cost is made of into ' ...
                    'runs.csv, a column each, and their measured values into ' ...
                    'loadInput.m.'];
end

%!assert (numel (costTexts (struct ('runs', 1, 'failed', 0, 'outside', 0))), 3)
%!assert (numel (costTexts (struct ('runs', 3, 'failed', 1, 'outside', 0))), 4)

% SPDX-License-Identifier: GPL-3.0-only
