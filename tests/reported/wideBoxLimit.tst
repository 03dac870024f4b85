% Limits 0 to 1000, best value 3 between 2.9 and 3.1: within 0.5 % of the box from
% a limit, and thirty widths of its interval away from it.

%!function c = calibrated (folder)
%!  [status, out] = startCommand (folder, 'run');
%!  assert (any (status == [0, 2]), '%s', out);
%!  c = readJsonFile (fullfile (folder, 'results', 'calibration.json'));
%!endfunction
%!shared folder
%! folder = reportedCase ('wideBoxLimit');

%!test
%! c = calibrated (folder);
%! assert (c.params.offset, 3, 0.2);
%! assert (isempty (c.atLimit), '%s', strjoin (cellstr (c.atLimit)));
%! assert (isempty (regexp (strjoin (cellstr (c.warnings)), 'at a limit')));

%!test
%! % a limit that the interval does reach is said
%! file = fullfile (folder, 'loadInput.m');
%! writeAtomic (file, strrep (fileread (file), '[0, 0.1;', '[2.98, 0.1;'));
%! c = calibrated (folder);
%! assert (cellstr (c.atLimit), {'offset'});

% SPDX-License-Identifier: GPL-3.0-only
