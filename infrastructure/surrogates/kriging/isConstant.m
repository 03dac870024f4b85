% ISCONSTANT  True where a response is the same in all runs, but for rounding.
%
% CALL: YES = isConstant (Z)
%
% Z  n x 1

function yes = isConstant (z)
  yes = std (z) <= 100 * eps (max (abs (z)));
end

%!assert (isConstant (0.1 * [3; 3; 3]))
%!assert (isConstant (0))
%!assert (~isConstant ([1; 1 + 1e-9]))

% SPDX-License-Identifier: GPL-3.0-only
