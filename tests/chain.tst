% The example of a chain: a bed is poured, then tapped from the state that was left.
% LIGGGHTS runs. Broken off in the middle, the calibration goes on with what is there.

%!test
%! root = fileparts (fileparts (which ('startProgram')));
%! folder = tempname ();
%! mkdir (folder);
%! copyfile (fullfile (root, 'examples', 'tapped', '*'), folder);
%! confirm_recursive_rmdir (false, 'local');
%! for name = {'optim', 'results', 'KrigingFuns'}
%!   [~, ~] = rmdir (fullfile (folder, name{1}), 's');
%! end
%! [status, out] = startCommand (folder, 'check');
%! assert (status == 0, out);
%! assert (~isempty (strfind (out, 'starts from Loose, run once')), out);
%! assert (isempty (strfind (out, 'WARNING')), out);
%! % broken off when the first states are there
%! start = sprintf ('cd %s && exec setsid %s run > out.txt 2>&1', ...
%!                  shellQuote (folder), ...
%!                  shellQuote (fullfile (root, 'bin', 'decalioc')));
%! [~, pid] = system ([start, ' & echo $!']);
%! records = @(model) glob (fullfile (folder, 'optim', model, '*', ...
%!                                    'record.json'));
%! waitUntil (@() numel (records ('Loose')) > 2);
%! pid = strtrim (pid);
%! system (['pkill -INT -s ', pid]);
%! waitUntil (@() system (['pgrep -s ', pid, ' > /dev/null']) ~= 0);
%! before = records ('Loose');
%! assert (numel (before) > 2);
%! [status, out] = startCommand (folder, 'run');
%! assert (status == 0, out);
%! c = jsondecode (fileread (fullfile (folder, 'results', 'calibration.json')));
%! for truth = struct ('name', {'densityP', 'coefFrictionPP'}, 'value', {2000, 0.4})
%!   range = c.interval90.(truth.name);
%!   assert (range(1) <= truth.value && truth.value <= range(2), out);
%! end
%! % each state once; each run of Tapped starts from one of the same packing
%! runs = cellfun (@readRecord, records ('Loose'));
%! assert (numel (unique ({runs.key})) == numel (runs));
%! assert (all ([runs(ismember (records ('Loose'), before)).seconds] > 0));
%! for file = records ('Tapped')'
%!   tapped = readRecord (file{1});
%!   loose = readRecord (fullfile (fileparts (file{1}), 'Loose', 'record.json'));
%!   assert ({loose.seed, loose.params}, {tapped.seed, tapped.params});
%! end
%! rmdir (folder, 's');

% SPDX-License-Identifier: GPL-3.0-only
