% Flow of measured.csv: a curve of 50 correlated points, repeated trials, a
% target of 0 and a setting that nobody has measured, to verdict and next test.

%!function s = readJson (folder, name)
%!  s = jsondecode (fileread (fullfile (folder, name)));
%!endfunction

%!shared folder
%! folder = tempname ();
%! measuredCase (folder);

%!test
%! % every mistake of the table at once, before anything is run
%! file = fullfile (folder, 'measured.csv');
%! good = fileread (file);
%! text = strrep (good, 'Bin;drift;0;0,02;m;;;;;0,1 abs', ...
%!                'Bin;drift;0;0,02;m;;;;;5%');
%! text = strrep (text, 'Bin;wide;;', 'Bin;wade;;');
%! writeAtomic (file, text);
%! [status, ~, err] = startProgram (folder);
%! writeAtomic (file, good);
%! assert (status, 1);
%! for words = {'2 problems in', 'measured.csv, line 5, tol', ...
%!              'measured.csv, line 6', 'Did you mean wide?'}
%!   assert (! isempty (strfind (err, words{1})), words{1});
%! end
%! assert (! isfolder (fullfile (folder, 'optim')));

%!test
%! % calibration: the model lacks an effect, so the curve cannot be met
%! [status, out, err] = startProgram (folder);
%! assert (err, '');
%! assert (status, 2);
%! c = readJson (folder, 'results/calibration.json');
%! assert (numel (c.targets), 33);     % 30 points of the curve
%! assert ({c.targets(1:3).name}, {'rest', 'drift', 'wide'});
%! assert ({c.targets(1:3).role}, {'calibrate', 'calibrate', 'unmeasured'});
%! assert (c.targets(1).target, 3.16, 1e-12);
%! % 1.32 s / sqrt (3)
%! assert (c.targets(1).sd, 1.32 * 0.01 / sqrt (3), 1e-4);
%! assert (isempty (c.targets(3).target));
%! % not measured: predicted, with an interval
%! assert (c.holdout.name, 'wide');
%! assert (c.holdout.result, 3 * c.params.a, 0.1);
%! assert (diff (c.holdout.interval90) > 0);
%! assert (! isempty (strfind (out, 'discharge (30 points)')));
%! assert (! isempty (strfind (out, 'not measured: wide predicted')));
%! assert (isfile (fullfile (folder, 'results', 'report.html')));

%!test
%! % other places on the curve: evaluated again, nothing simulated again
%! file = fullfile (folder, 'measured.csv');
%! good = fileread (file);
%! n = numel (listRunFolders (folder, 'Bin'));
%! here = cd (folder);
%! clear loadInput
%! raw = readInput (fileparts (which ('DEcalioc')), folder);
%! cd (here);
%! clear loadInput
%! writeAtomic (file, strrep (good, ';0,055;', ';0,057;'));
%! moved = gatherRuns (newCase (raw));
%! writeAtomic (file, good);
%! data = gatherRuns (newCase (raw));
%! assert (numel (listRunFolders (folder, 'Bin')), n);
%! assert (moved.Z(:, 5:end), data.Z(:, 5:end));
%! assert (all (moved.Z(:, 4) ~= data.Z(:, 4)));

%!test
%! % diagnosis: the effect is named, though one target never scatters; the
%! % unmeasured setting is offered with cost
%! root = fileparts (which ('DEcalioc'));
%! [status, out, err] = startProgram (folder, ...
%!                        shellQuote (fullfile (root, 'diagnoseGap.m')));
%! assert (err, '');
%! assert (status, 0);
%! g = readJson (folder, 'gap/gap.json');
%! assert (g.which.verdict, 'named');
%! assert (g.which.effects, {'slow'});
%! s = g.which.strength.slow.interval90;
%! % 0.08 of 0.12; a 90 % interval, doubled
%! assert (abs (0.667 - mean (s)) < diff (s));
%! next = g.next(strcmp ({g.next.test}, 'Bin: measure wide'));
%! assert (numel (next), 1);
%! assert (next.gain >= 0);
%! table = fileread (fullfile (folder, 'results', 'tables', 'next.csv'));
%! assert (! isempty (regexp (table, 'Bin: measure wide[^,]*,[-.e\d]+,4')));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');

% SPDX-License-Identifier: GPL-3.0-only
