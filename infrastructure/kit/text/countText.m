% COUNTTEXT  A number with its noun: 1 run, 2 runs.
%
% CALL: TEXT = countText (N, ONE)
%       TEXT = countText (N, ONE, MANY)
%
%   N     whole number, 0 or more
%   ONE   what follows where N is 1 (text): 'run', 'run fails'
%   MANY  what follows else; by default ONE with an s

function text = countText (n, one, many)
  if nargin < 3
    many = [one, 's'];
  end
  text = sprintf ('%d %s', n, merge (n == 1, one, many));
end

%!assert (countText (0, 'run'), '0 runs')
%!assert (countText (1, 'run'), '1 run')
%!assert (countText (1e6, 'run fails', 'runs fail'), '1000000 runs fail')

% SPDX-License-Identifier: GPL-3.0-only
