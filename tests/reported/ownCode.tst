% Issue 47, 8: a DEM code of one's own, in the loop "run this set, add it to
% runs.csv, start again". It ends; and the set that is to be run is one that was
% run once its rows meet the targets.

%!function c = started (folder)
%!  [status, out] = startCommand (folder, 'run');
%!  assert (status < 3 && isempty (strfind (out, 'error:')), out);
%!  c = jsondecode (fileread (fullfile (folder, 'results', ...
%!                                      'calibration.json')));
%!endfunction
%!function addRow (folder, p)
%!  file = fullfile (folder, 'runs.csv');
%!  z = [20 + 15 * p.a + 10 * p.b, 800 - 60 * p.a + 20 * p.b^2];
%!  writeAtomic (file, [fileread(file), sprintf("%.4f,%.4f,%.3f,%.2f\n", ...
%!                                              p.a, p.b, z)]);
%!endfunction
%!test
%! folder = reportedCase ('ownCode');
%! c = started (folder);
%! assert (! c.converged);
%! % the set is copied with four decimals
%! addRow (folder, c.params);
%! first = c.params;
%! c = started (folder);
%! assert (c.converged, true);
%! assert ([c.params.a, c.params.b], [first.a, first.b], 5.1e-5);
%! assert (c.runs, 1);
%! % another start changes nothing, nor does one more row there
%! addRow (folder, c.params);
%! again = started (folder);
%! assert (again.params, c.params);
%! assert (again.converged, true);

% SPDX-License-Identifier: GPL-3.0-only
