% Flows with levels (Input.coarse) on stand-in models.

%!function c = calibrationOf (folder)
%!  c = jsondecode (fileread (fullfile (folder, 'results', ...
%!                                      'calibration.json')));
%!endfunction

%!shared folder, first, lines
%! folder = tempname ();
%! standInCase (folder);
%! lines = ["own = struct ('variable', 'e', 'levels', [0.4, 0.2, 0]);\n", ...
%!          'Input.coarse = {own, own};'];
%! writeLoadInput (folder, lines);

%!function writeRuns (place, X, e, noise)
%!  % runs made elsewhere, as the case folder holds them
%!  Z = [sum(X, 2), prod(X, 2), X(:, 1) - X(:, 2)] + e + noise;
%!  text = {'model,e,a,b,First_1,First_2,Second_1'};
%!  for i = 1:rows (X)
%!    set = sprintf ('%.17g,%.17g,%.17g', e(i), X(i, :));
%!    text{end + 1} = sprintf ('First,%s,%.17g,%.17g,', set, Z(i, 1:2));
%!    text{end + 1} = sprintf ('Second,%s,,,%.17g', set, Z(i, 3));
%!  end
%!  writeAtomic (fullfile (place, 'runs.csv'), [strjoin(text, "\n"), "\n"]);
%!endfunction

%!test
%! % the set is that of the last level, and confirmed there; each level is told
%! [status, out, err] = startProgram (folder);
%! assert (err, '');
%! assert (status, 0);
%! first = calibrationOf (folder);
%! assert (first.params.a, 4, 0.05);
%! assert (first.params.b, 3, 0.05);
%! assert ([first.levels.value], [0.4, 0.2, 0]);
%! assert (all ([first.levels.runs] >= 1));
%! off = abs (first.levels(1).shift - 0.4);
%! assert (all (off < 0.05 + 4 * first.levels(1).shiftSd));
%! assert (first.levels(3).shift, zeros (3, 1));
%! assert (! isempty (strfind (out, 'e = 0.4')));
%! assert (columns (csvread (fullfile (folder, ...
%!                                     'ExperimentalPlan_DoE.csv'))), 3);
%! html = fileread (fullfile (folder, 'results', 'report.html'));
%! assert (! isempty (strfind (html, 'the level that counts')));

%!test
%! % a second start repeats no run and gives the same set
%! n = numel (listRunFolders (folder, 'First'));
%! [status, ~, err] = startProgram (folder);
%! assert (err, '');
%! assert (numel (listRunFolders (folder, 'First')), n);
%! assert (calibrationOf (folder).params, first.params);

%!test
%! % the diagnosis and the best set so far know the runs of the last level alone
%! root = fileparts (which ('DEcalioc'));
%! was = cd (folder);
%! restore = onCleanup (@() cd (was));
%! startToolbox (root, folder);
%! Case = loadCase (root, folder);
%! runs = runsOfCase (Case);
%! assert (all ([runs.isCurrent]));
%! best = bestSet (Case, runs, []);
%! assert (best.params, [first.params.a, first.params.b], 0.05);
%! assert (best.results, [7, 12, 1], 0.2);
%! data = gatherRuns (withEffects (Case, []));
%! data = keepRows (data, data.E == 0);
%! assert (rows (data.X), first.levels(3).runs);
%! assert (data.Z(:, 1), sum (data.X, 2), 1e-9);

%!test
%! % runs of another level that exist already count, without a model too
%! other = tempname ();
%! standInCase (other);
%! writeLoadInput (other, [lines, ' Input.maxNewRuns = 0;']);
%! rand ('twister', 3);
%! X = 10 * rand (12, 2);
%! X(11:12, :) = [4, 3; 4.02, 2.99];
%! e = [0.4 * ones(10, 1); 0; 0];
%! writeRuns (other, X, e, zeros (12, 3));
%! [status, out, err] = startProgram (other);
%! assert (err, '');
%! c = calibrationOf (other);
%! assert ([c.levels.runs], [10, 0, 2]);
%! assert (c.params.a, 4, 0.1);
%! assert (c.params.b, 3, 0.1);

%!test
%! % a level that no model has, or that is calibrated, is refused before any run
%! other = tempname ();
%! standInCase (other);
%! bad = {"Input.coarse = {struct('variable', 'size', 'levels', [2, 1])};", ...
%!        'size'; ...
%!        "Input.coarse = {struct('variable', 'a', 'levels', [2, 1])};", ...
%!        'either calibrated or a level'; ...
%!        "Input.coarse = {struct('variable', 'e', 'levels', 1)};", ...
%!        'two and more numbers'};
%! for k = 1:rows (bad)
%!   writeLoadInput (other, bad{k, 1});
%!   [status, ~, err] = startProgram (other);
%!   assert (status, 1);
%!   assert (! isempty (strfind (err, bad{k, 2})));
%!   assert (! isfolder (fullfile (other, 'optim')));
%! end

%!test
%! % a verdict says at which level it was reached, and whether it would hold at
%! % the next finer one: e = 0.4, 0.2 and 0, then -0.2
%! other = tempname ();
%! standInCase (other);
%! writeLoadInput (other, [lines, ' Input.maxNewRuns = 0; ', ...
%!                         'optim.targetStd = {[0.02, 0.05], 0.02};']);
%! text = "function effects = loadEffects ()\neffects = {'gain'};\nend\n";
%! writeAtomic (fullfile (other, 'loadEffects.m'), text);
%! weighedResults (other);
%! rand ('twister', 3);
%! randn ('twister', 3);
%! X = 10 * rand (40, 2);
%! e = [0.4 * ones(10, 1); 0.2 * ones(5, 1); zeros(25, 1)];
%! writeRuns (other, X, e, 0.01 * randn (40, 3));
%! root = fileparts (which ('DEcalioc'));
%! [status, out, err] = startProgram (other, shellQuote ( ...
%!                                      fullfile (root, 'diagnoseGap.m')));
%! assert (err, '');
%! assert (! isempty (strfind (out, 'LEVEL: reached at e = 0. At e = -0.2')));
%! gap = jsondecode (fileread (fullfile (other, 'gap', 'gap.json')));
%! assert (gap.level.finer, -0.2, 1e-12);
%! assert (gap.level.shift, -0.2 * ones (3, 1), 0.1);
%! assert (islogical (gap.level.holds));

% SPDX-License-Identifier: GPL-3.0-only
