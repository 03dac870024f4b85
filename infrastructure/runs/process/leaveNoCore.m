% LEAVENOCORE  Ended by a signal, this Octave leaves no file octave-workspace.
%
% CALL: leaveNoCore ()
%
% For workers of parcellfun too: each is an Octave of its own, which has none of
% the settings of the one that has started it, and a queue that ends a job, or a
% terminal that is closed, signals all of them. worker.octaverc does the same
% before their first call, see startToolbox.

function leaveNoCore ()
  sigterm_dumps_octave_core (false);
  sighup_dumps_octave_core (false);
end

%!test
%! before = {sigterm_dumps_octave_core(true), sighup_dumps_octave_core(true)};
%! leaveNoCore ();
%! after = {sigterm_dumps_octave_core(before{1}), ...
%!          sighup_dumps_octave_core(before{2})};
%! assert (after, {false, false});

% SPDX-License-Identifier: GPL-3.0-only
