% NORMALTAIL  Gives the upper tail of the standard normal distribution.
%
% CALL: P = normalTail (X)
%
%   X   any shape
%   P   probability of a value above X

function p = normalTail (x)
  p = 0.5 * erfc (x / sqrt (2));
end

%!assert (normalTail (0), 0.5)
%!assert (normalTail (1.959963984540054), 0.025, 1e-12)

% SPDX-License-Identifier: GPL-3.0-only
