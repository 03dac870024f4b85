% A curve that no values meet (chance below 1 %) got intervals without a remark, where
% single numbers as targets get none.

%!test
%! folder = reportedCase ('curveIntervalsAnyway');
%! [status, out] = startCommand (folder, 'run');
%! assert (status == 2, out);
%! assert (! isempty (strfind (out, 'The intervals are not printed')), out);
%! c = readJsonFile (fullfile (folder, 'results', 'calibration.json'));
%! assert (c.intervalCode, 'no fit');

% SPDX-License-Identifier: GPL-3.0-only
