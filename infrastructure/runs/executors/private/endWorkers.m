% ENDWORKERS  Ends the workers of parcellfun; those that are gone are no fault.
%
% CALL: endWorkers ()
%
% parcellfun_set_nproc gives an error where it cannot end one, which must not
% end a calibration: the next parcellfun makes a pool of its own, or says so.

function endWorkers ()
  try
    parcellfun_set_nproc (0);
  catch
    % see above
  end
end

%!test
%! % also where they were killed
%! parcellfun (2, @(x) x, {1, 2}, 'VerboseLevel', 0);
%! system (sprintf ('pkill -KILL -P %d octave', getpid ()));
%! endWorkers ();
%! assert (parcellfun (2, @(x) x, {1, 2}, 'VerboseLevel', 0), [1, 2]);

% SPDX-License-Identifier: GPL-3.0-only
