% A curve of 400 points took more than nine minutes where 20 points took half of one,
% and gave the same values.

%!test
%! folder = reportedCase ('denseCurve');
%! copyfile (fullfile (folder, 'measured400.csv'), fullfile (folder, 'measured.csv'));
%! [status, out] = startCommand (folder, 'check');
%! assert (status == 0, out);
%! assert (! isempty (strfind (out, 'curve discharge: 30 points, one requirement')), out);
%! assert (! isempty (strfind (out, '370 points of its dense curves are not fitted')), out);
%! [status, out] = startCommand (folder, 'run');
%! assert (any (status == [0, 2]), out);
%! c = readJsonFile (fullfile (folder, 'results', 'calibration.json'));
%! assert (numel (c.targets), 31);

% SPDX-License-Identifier: GPL-3.0-only
