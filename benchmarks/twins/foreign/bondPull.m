% BONDPULL  How much dry cohesion matters, by its Bond number.
%
% CALL: B = bondPull (STRENGTH, DEAD, HALF)
%
%   STRENGTH  any shape, cohesion energy over its limit
%   DEAD      scalar, below this strength nothing is to be seen
%   HALF      scalar, strength above DEAD (over 1 - DEAD) at which half of what
%             saturates is reached
%   B         same shape, exactly 0 up to DEAD, 1 at STRENGTH 1
%
% The pull-off force of Hertz contacts with SJKR cohesion grows with the cube of
% the cohesion energy density; the bulk feels it from a Bond number of about 0.1
% and saturates when all contacts hold.
%
% See also: bridgePull, foreignLab

function B = bondPull (strength, dead, half)
  x = max (0, (strength - dead) / (1 - dead)).^3;
  B = x * (1 + half^3) ./ (x + half^3);
end

%!test % dead zone, cubic start, one at full strength, monotone
%! assert (bondPull ([0, 0.1, 0.2], 0.2, 0.6), [0, 0, 0]);
%! assert (bondPull (1, 0.2, 0.6), 1, 1e-12);
%! B = bondPull (0.2 + 0.8 * [0.01, 0.02], 0.2, 0.6);
%! assert (B(2) / B(1), 8, 0.01);
%! assert (all (diff (bondPull (0.3:0.05:1.2, 0.2, 0.6)) > 0));
