% EMPTYINGCURVE  Mass that has left a bin over time.
%
% CALL: M = emptyingCurve (TIME, RATE, STEADY, ALL)
%
%   TIME    1 x m or n x m (s); nothing has left before 0
%   RATE    n x 1, mass flow (kg/s), above 0
%   STEADY  n x 1, mass after which the surface reaches the opening (kg)
%   ALL     n x 1, mass that leaves in the end (kg), above STEADY
%   M       n x m (kg): RATE TIME up to STEADY, then towards ALL as 1 - exp,
%           without a jump in the rate
%
% See also: dischargeRate, foreignLab

function M = emptyingCurve (time, rate, steady, all)
  flown = rate .* max (0, time);
  late = max (0, flown - steady);
  tail = all - steady;
  M = min (flown, steady) - tail .* expm1 (-late ./ tail);
end

%!test
%! M = emptyingCurve ([-1, 0, 2, 4, 4.001, 1e3], 0.5, 2, 3);
%! assert (M(1:4), [0, 0, 1, 2], 1e-12);
%! assert ((M(5) - M(4)) / 0.001, 0.5, 1e-3);
%! assert (M(6), 3, 1e-12);
