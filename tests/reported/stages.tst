% Issue 47, 2 and 8: two stages of one campaign, each with one target, and a run
% that is off by 40 scatters: the calibration ended in a crash.

%!test
%! folder = reportedCase ('stages', 'pile');
%! [status, out] = startCommand (folder, 'run');
%! assert (status == 2, out);
%! assert (! isempty (strfind (out, '24 runs taken in')));
%! % nothing can be run once more: it counts, and that is said
%! assert (! isempty (regexp (out, ['gave angle = 34.72; the other runs ' ...
%!                                  'predict 30.*so it counts'])), out);
%! % one odd run is no jump
%! assert (isempty (strfind (out, 'jumps past')), out);
%! assert (! isempty (strfind (out, 'add the run to runs.csv')), out);

% SPDX-License-Identifier: GPL-3.0-only
