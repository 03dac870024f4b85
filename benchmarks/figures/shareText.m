% SHARETEXT  A share with its exact interval of 95 % (Clopper-Pearson), as text.
%
% CALL: TEXT = shareText (IS)
%       TEXT = shareText (IS, AMONG)
%
%   IS     1 x n logical, what is counted;  AMONG  1 x n logical, those that count
%          (default: all)
%   TEXT   e.g. 52/73 = 71 % (59-81); '-' where none counts
%
% See also: binomialInterval

function text = shareText (is, among)
  if nargin < 2
    among = true (size (is));
  end
  [k, n] = deal (sum (is & among), sum (among));
  if n == 0
    text = '-';
    return
  end
  [lo, hi] = binomialInterval (k, n);
  text = sprintf ('%d/%d = %.0f %% (%.0f-%.0f)', k, n, 100 * [k / n, lo, hi]);
end

%!assert (shareText ([1, 1, 0] > 0, [1, 0, 1] > 0), '1/2 = 50 % (1-99)')
%!assert (shareText (true, false), '-')

% SPDX-License-Identifier: GPL-3.0-only
