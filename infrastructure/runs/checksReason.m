% CHECKSREASON  Says why a run's own checks call it not sane.
%
% CALL: TEXT = checksReason (FOLDER)
%
%   FOLDER  folder of a finished run (text)
%   TEXT    ' (reason)' by output_checks.csv; '' where the run is sane, or its
%           model writes no such file
%
% See also: evaluateRun, readChecks

function text = checksReason (folder)
  text = '';
  try
    checks = readChecks (folder);
  catch
    % a model of one's own need not have checks
    return
  end
  if ~checks.sane
    text = sprintf (' (%s)', checks.reason);
  end
end

%!test
%! folder = tempname ();
%! mkdir (folder);
%! assert (checksReason (folder), '');
%! lines = @(overlap) sprintf (['spheresStart,10\nspheresOut,4\n', ...
%!                              'spheresEnd,6\nsettled,1\noverlapMax,%g\n'], ...
%!                             overlap);
%! file = fullfile (folder, 'output_checks.csv');
%! writeAtomic (file, lines (0.01));
%! assert (checksReason (folder), '');
%! writeAtomic (file, lines (0.118));
%! assert (checksReason (folder), [' (overlap of 0.118 diameters, 0.08 at ' ...
%!         'most: take stiffer grains or slower walls)']);
%! unlink (file);
%! rmdir (folder);
