% TOOOFTENNONE  Chance that packings of a set end without a result too often.
%
% CALL: CHANCE = tooOftenNone (NONE, N)
%
%   NONE, N  k x 1: runs of a set without a result, of all N runs there
%   CHANCE   k x 1: that more than a quarter of all packings would (Jeffreys' prior);
%            0 below two: one run is lost for many reasons
%
% A crash of the machine takes a run now and then. A bin that clogs at every
% second packing is an outcome: how the others end says nothing of the material.

function chance = tooOftenNone (none, n)
  chance = betainc (0.25, none + 0.5, n - none + 0.5, 'upper');
  chance(none < 2) = 0;
end

%!assert (tooOftenNone ([0; 1; 2; 5], [9; 1; 2; 8]) > 0.95, [false; false; true; true])
%!assert (tooOftenNone ([2; 2; 2], [5; 7; 12]) > 0.5, [true; true; false])
%!assert (tooOftenNone ([2; 3], [20; 6]) > 0.95, [false; false])

% SPDX-License-Identifier: GPL-3.0-only
