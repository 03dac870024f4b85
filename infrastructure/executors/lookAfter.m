% LOOKAFTER  How long to wait before the next look at the runs under way.
%
% CALL: SECONDS = lookAfter (AGES)
%
%   AGES     1 x n, how long each run has been under way (s); may be empty
%   SECONDS  scalar
%
% A look costs part of a millisecond of processor time a run. Looking every 20
% ms took a tenth of a core from the simulations. An ended run is seen late by a
% hundredth of its length at most, and by a second at most.
%
% See also: executeLocal

function seconds = lookAfter (ages)
  seconds = min (max ([0.02, 0.01 * min(ages)]), 1);
end

%!assert (lookAfter ([]), 0.02)
%!assert (lookAfter (0.5), 0.02)
%!assert (lookAfter ([700, 40]), 0.4, eps)
%!assert (lookAfter ([700, 900]), 1)
