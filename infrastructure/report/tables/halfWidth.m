% HALFWIDTH  Half of the band about the measured value that is tolerated.
%
% CALL: HALF = halfWidth (TARGET)
%
%   TARGET  element of Case.targets
%   HALF    in its unit

function half = halfWidth (target)
  half = target.tol;
  if ~target.isAbsolute
    half = abs (target.value) * target.tol;
  end
end

%!assert (halfWidth (struct ('value', -4, 'tol', 0.1, ...
%!                         'isAbsolute', false)), 0.4, 1e-12)
%!assert (halfWidth (struct ('value', 0, 'tol', 3, 'isAbsolute', true)), 3)

% SPDX-License-Identifier: GPL-3.0-only
