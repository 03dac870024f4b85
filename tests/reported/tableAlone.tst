% Issue 53, strangers 5 and 12: runs of a table alone; of the model there is only
% results.csv, or nothing at all; a candidate that can act on nothing.

%!test
%! folder = reportedCase ('tableAlone', 'pile');
%! [status, out] = startCommand (folder, 'check');
%! assert (status == 0, out);
%! assert (! isempty (strfind (out, 'runs.csv  6 sets taken in')), out);
%! assert (isempty (regexp (out, 'WARNING|LIGGGHTS|cost|plan')), out);
%! [status, out] = startCommand (folder, 'run');
%! assert (any (status == [0, 2]), out);
%! assert (isfile (fullfile (folder, 'results', 'calibration.json')));
%! assert (! isempty (strfind (out, 'add the run to runs.csv')), out);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (fullfile (folder, 'DEMmodels'), 's');
%! writeAtomic (fullfile (folder, 'loadEffects.m'), ...
%!              ["function effects = loadEffects ()\n", ...
%!               "  effects = {'speedError'};\nend\n"]);
%! [status, out] = startCommand (folder, 'check');
%! assert (status == 0, out);
%! assert (! isempty (strfind (out, 'can express speedError')), out);
%! assert (! isempty (strfind (out, 'no candidate of loadEffects.m can')), out);
%! [status, out] = startCommand (folder, 'diagnose');
%! assert (status == 1, out);
%! assert (! isempty (strfind (out, 'got speedError, which no result')), out);

% SPDX-License-Identifier: GPL-3.0-only
