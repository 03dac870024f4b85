% Issue 47, 7 and 9: a table without noise, z = a^2 + b^2; the intervals were
% 0.03, 0.4 and 1.7 wide, and the set lay outside all three.

%!test
%! folder = reportedCase ('noNoise');
%! startCommand (folder, 'run');
%! c = readJsonFile (fullfile (folder, 'results', 'calibration.json'));
%! for name = {'a', 'b'}
%!   range = c.interval90.(name{1});
%!   assert (range(1) < -2.5 && range(2) > 2.5);
%!   assert (c.params.(name{1}) >= range(1) && c.params.(name{1}) <= range(2));
%! end
%! assert (c.intervalCode, 'unseen');
%! assert (! isempty (strfind (c.intervalNote, 'optim.targetStd')));

% SPDX-License-Identifier: GPL-3.0-only
