% ZCLASS  How strongly a miss over noise is coloured.
%
% CALL: CLASS = zClass (Z)
%
%   Z      scalar, a miss over its noise
%   CLASS  'z0' ... 'z3': up to 1, 2, 3, beyond (page.css)

function class = zClass (z)
  class = sprintf ('z%d', sum (abs (z) >= 1:3));
end

%!assert (zClass (-2.5), 'z2')
%!assert (zClass (NaN), 'z0')

% SPDX-License-Identifier: GPL-3.0-only
