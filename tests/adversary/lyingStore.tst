% A store that lies: no code is run, no raw error, no false sample.

%!test
%! n = 30;
%! if strcmp (getenv ('DECALIOC_SOAK'), '1')
%!   n = 500;
%! end
%! addpath (fullfile (fileparts (which ('standInCase')), 'fuzz'));
%! [failures, count] = fuzzStore (n, 7);
%! assert (isempty (failures), strjoin (failures, "\n"));
%! assert (count.index + count.record + count.surrogate, n);

% SPDX-License-Identifier: GPL-3.0-only
