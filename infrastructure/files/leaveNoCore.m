% LEAVENOCORE  Ended by a signal, this Octave leaves no file octave-workspace.
%
% CALL: leaveNoCore ()
%
% Nor do workers of parcellfun: each is an Octave of its own, which has none of
% the settings of the one that has started it, and a queue that ends a job, or a
% terminal that is closed, signals all of them, also before their first call.
% Where OCTAVE_SITE_INITFILE is set already, they do so from their first call on.

function leaveNoCore ()
  sigterm_dumps_octave_core (false);
  sighup_dumps_octave_core (false);
  if isempty (getenv ('OCTAVE_SITE_INITFILE'))
    here = fileparts (mfilename ('fullpath'));
    setenv ('OCTAVE_SITE_INITFILE', fullfile (here, 'worker.octaverc'));
  end
end

%!test
%! before = {sigterm_dumps_octave_core(true), sighup_dumps_octave_core(true)};
%! leaveNoCore ();
%! after = {sigterm_dumps_octave_core(before{1}), ...
%!          sighup_dumps_octave_core(before{2})};
%! assert (after, {false, false});
%!test
%! % a worker has the settings before it is called, and does not hand on how
%! leaveNoCore ();
%! given = ['disp ([sigterm_dumps_octave_core(), sighup_dumps_octave_core(), ' ...
%!          'isempty(getenv (''OCTAVE_SITE_INITFILE''))])'];
%! [status, out] = system (['octave-cli --no-history --eval ', shellQuote(given)]);
%! assert (status, 0);
%! assert (sscanf (out, '%d')', [0, 0, 1]);
