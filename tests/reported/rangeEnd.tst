% The true grain size is 0.5, its range ends at 0.75: "none of the listed causes" sent
% the user to look for others, while the table had the size at 0.756.

%!test
%! folder = reportedCase ('rangeEnd');
%! startCommand (folder, 'run');
%! [status, out] = startCommand (folder, 'diagnose');
%! assert (status, 0);
%! gap = readJsonFile (fullfile (folder, 'gap', 'gap.json'));
%! assert (gap.which.verdict, 'none of the listed');
%! assert ({gap.cause.code, gap.action.code}, {'atEnd', 'widenCause'});
%! assert (cellstr (gap.action.widen), {'grainSize'});
%! for part = {'grainSize at 0.75, the end of its range', ...
%!             'Widen the range of grainSize in loadEffects.m'}
%!   assert (! isempty (strfind (out, part{1})), out);
%! end

% SPDX-License-Identifier: GPL-3.0-only
