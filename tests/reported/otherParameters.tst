% Two rigs, of which one does not have the parameter wall: its rows were refused, and
% no column was named.

%!test
%! folder = reportedCase ('otherParameters');
%! [status, out] = startCommand (folder, 'check');
%! assert (status == 0 && ! isempty (strfind (out, '28 sets taken in')), out);
%! [status, out] = startCommand (folder, 'run');
%! assert (any (status == [0, 2]), out);
%! assert (isempty (strfind (out, 'warning: ')), out);
%! c = readJsonFile (fullfile (folder, 'results', 'calibration.json'));
%! % wall acts in RigB alone; angle and lean are those of RigA
%! assert (c.sensitivity.wall(1:2) < 0.05);
%! assert ([c.targets.result], [31, 5, 12], [0.7, 0.15, 0.3]);
%! % a single field that is empty is a mistake
%! file = fullfile (folder, 'runs.csv');
%! writeAtomic (file, regexprep (fileread (file), 'RigB,10003,0.242857,0.3416,0.2001', ...
%!                               'RigB,10003,0.242857,0.3416,'));
%! [status, out] = startCommand (folder, 'check');
%! assert (status == 1 && ! isempty (strfind (out, 'got none for wall')), out);

% SPDX-License-Identifier: GPL-3.0-only
