% A largest radius b below the smallest one, a, ends a run: half of the box is of
% no use, and a third of the plan failed. Conditions and listed values keep to
% what can be run. The truth is a = 0.6, b = 0.65; scatter 0.01; one seed.

%!function P = setsOf (folder)
%!  names = listRunFolders (folder, 'M');
%!  P = cellfun (@(n) readRecord (fullfile (folder, 'optim', 'M', n, ...
%!                                          'record.json')).params, ...
%!               names(:), 'UniformOutput', false);
%!  P = vertcat (P{:});
%!endfunction

%!function add (folder, text)
%!  file = fullfile (folder, 'loadInput.m');
%!  was = fileread (file);
%!  writeAtomic (file, [was(1:end - 4), text, "\nend\n"]);
%!endfunction

%!shared folder
%! folder = reportedCase ('order');

%!test <*47>
%! [status, out] = startCommand (folder, 'run');
%! assert (status == 0, '%s', out);
%! c = readJsonFile (fullfile (folder, 'results', 'calibration.json'));
%! assert (c.converged);
%! assert ([c.params.a, c.params.b], [0.6, 0.65], 0.04);
%! assert (c.demRuns.failed, 0);
%! assert (c.constraints, {'a < b'});

%!test <*47>
%! % only such sets were run, and such sets fit
%! P = [setsOf(folder); ...
%!      dlmread(fullfile (folder, 'results', 'posterior.csv'), ',', 1, 0)];
%! assert (P(:, 1) < P(:, 2));
%! % the plan still fills what is left: none of its parts is bare
%! plan = P(1:9, :);
%! assert (any (plan(:, 1) > 0.6) && any (plan(:, 2) < 0.4));
%! assert (any (plan(:, 1) < 0.3 & plan(:, 2) > 0.7));

%!test <*47>
%! % listed values: the runs so far count, the result is one of the list
%! add (folder, 'Input.values.b = 0.05:0.1:0.95;');
%! n = rows (setsOf (folder));
%! [status, out] = startCommand (folder, 'run');
%! assert (status == 0, '%s', out);
%! c = readJsonFile (fullfile (folder, 'results', 'calibration.json'));
%! assert (c.params.b, 0.65, 1e-12);
%! assert (c.params.a < c.params.b);
%! P = setsOf (folder)(n + 1:end, :);
%! assert (all (min (abs (P(:, 2) - (0.05:0.1:0.95)), [], 2) < 1e-12));

%!test
%! % nothing is left: said before anything is run
%! add (folder, 'Input.constraints = {''b < a'', ''a + 0.1 < b''};');
%! n = rows (setsOf (folder));
%! [status, out] = startCommand (folder, 'run');
%! assert (status ~= 0);
%! assert (any (strfind (out, 'one in 1000 sets between the limits')));
%! assert (rows (setsOf (folder)), n);

%!test
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');

% SPDX-License-Identifier: GPL-3.0-only
