% Issue 47, 8: two stages of one campaign in one table: half of the rows lack the
% one target, half the other. One angle is wrong.

%!test
%! folder = reportedCase ('twoStages', 'pile');
%! [status, out] = startCommand (folder, 'run');
%! assert (status == 2, out);
%! c = jsondecode (fileread (fullfile (folder, 'results', ...
%!                                     'calibration.json')));
%! assert ([c.targets.name], 'angledensity');
%! p = c.params;
%! assert (20 + 15 * p.a + 10 * p.b, 32, 0.02 * 32);
%! assert (800 - 60 * p.a + 20 * p.b^2, 780, 0.02 * 780);

% SPDX-License-Identifier: GPL-3.0-only
