% SHAKENSHARE  Share of the grains that vibration sets free, from 1 g on.
%
% CALL: S = shakenShare (ACCELERATION, SOON)
%
%   ACCELERATION  any shape, of the vibration over gravity, from 0
%   SOON          scalar, excess over 1 at which 1 - 1/e is reached
%   S             same shape, in [0, 1): exactly 0 up to 1
%
% See also: foreignLab

function S = shakenShare (acceleration, soon)
  S = -expm1 (-max (0, acceleration - 1) / soon);
end

%!test
%! S = shakenShare ([0, 0.5, 1, 1.1, 3, 100], 0.8);
%! assert (S(1:3), [0, 0, 0]);
%! assert (all (diff (S(3:6)) > 0));
%! assert (S(6), 1, 1e-12);
