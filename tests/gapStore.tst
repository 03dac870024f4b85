% Flow of the gap diagnosis: which runs of the store count.

%!test
%! % runs of the store count, with their effects, also after the list changes
%! addpath (fileparts (which ('startToolbox')));
%! raw = standInCase (tempname ());
%! own = struct ('name', 'own', 'variables', {{'e'}}, ...
%!               'neutral', 0, 'limits', [0; 5]);
%! Case = withEffects (newCase (raw), own);
%! Z = evaluateDEM ([2, 3; 2, 3; 4, 5], Case, [1; 2; 1], 'gap', ...
%!                  @(state) [], [0; 0; 2]);
%! [data, count] = gatherRuns (Case);
%! assert (count.stored, 6);
%! [~, order] = sortrows ([data.X, data.E, data.replicate]);
%! assert (data.X(order, :), [2, 3; 2, 3; 4, 5]);
%! assert (data.E(order), [0; 0; 2]);
%! assert (data.Z(order, :), Z);
%! % a list with one effect more, before it (the runs so far are of models
%! % that do not know it, and do not count)
%! longer = [struct('name', 'new', 'variables', {{'b2'}}, ...
%!                  'neutral', 1, 'limits', [0; 5]), own];
%! for model = {'First', 'Second'}
%!   head = fullfile (raw.folder, 'DEMmodels', model{1}, 'data.head');
%!   writeAtomic (head, [fileread(head), "variable b2 equal 1\n"]);
%! end
%! Case = withEffects (newCase (raw), longer);
%! evaluateDEM ([2, 3; 4, 5], Case, 1, 'gap', @(state) [], [1, 0; 1, 2]);
%! [data, count] = gatherRuns (withEffects (newCase (raw), own));
%! assert (data.E, [0; 2]);
%! [data, count] = gatherRuns (Case);
%! assert (count.stored, 4);
%! assert (sortrows (data.E), [1, 0; 1, 2]);
%! longer = longer([2, 1]);
%! [data, count] = gatherRuns (withEffects (newCase (raw), longer));
%! assert (count.stored, 4);
%! assert (sortrows (data.E), [0, 1; 2, 1]);
%! % getResults was corrected: stored runs are evaluated again; so are those
%! % whose record was lost
%! funs = fullfile (raw.folder, 'DEMmodels', 'Second', 'OctaveFuns', ...
%!                  'getResults.m');
%! text = fileread (funs);
%! writeAtomic (funs, strrep (text, '(load (file)'')', '(10 * load (file)'')'));
%! unlink (fullfile (raw.folder, 'optim', 'Second', ...
%!                   listRunFolders (raw.folder, 'Second'){end}, ...
%!                   'record.json'));
%! later = gatherRuns (withEffects (newCase (raw), longer));
%! assert (later.Z(:, 3), 10 * data.Z(:, 3), 1e-9);
%! assert (later.Z(:, 1:2), data.Z(:, 1:2));
%! % a list without it
%! [data, count] = gatherRuns (newCase (raw));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (raw.folder, 's');
%! assert (count.stored, 2);
%! assert (data.X, [2, 3]);

%!test
%! % a run that ended well without a result is a row of NaN: where the slot
%! % jams tells something, and so does a packing that jams where others may not: no
%! % other one stands in for it. A crashed one tells nothing
%! addpath (fileparts (which ('startToolbox')));
%! raw = standInCase (tempname ());
%! Case = newCase (raw);
%! run = fullfile (raw.folder, 'DEMmodels', 'Second', 'runscript');
%! text = fileread (run);
%! jams = ['awk ''$2 == "a" && $4 > 5 { exit 1 }'' data.head || ', ...
%!         "{ echo NaN > out; exit 0; }\n"];
%! unlucky = ['awk ''$2 == "runSeed" && $4 % 2 { exit 1 }'' data.head || ', ...
%!            'awk ''$2 == "a" && $4 < 1 { exit 1 }'' data.head || ', ...
%!            'grep -q . ../used 2> /dev/null || ', ...
%!            "{ echo x > ../used; echo NaN > out; exit 0; }\n"];
%! dies = "awk '$2 == \"b\" && $4 > 7 { exit 1 }' data.head || exit 3\n";
%! writeAtomic (run, [dies, jams, unlucky, text]);
%! P = [2, 3; 6, 3; 2, 8; 0.5, 3];
%! Z = evaluateDEM (P, Case, 1, 'gap');
%! assert (isnan (Z(:, 3)), logical ([0; 1; 1; 1]));
%! [data, count] = gatherRuns (Case);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (raw.folder, 's');
%! [~, order] = sortrows (data.X);
%! assert (data.X(order, :), sortrows (P));
%! [~, same] = sortrows (P);
%! Z(3, 3) = NA;
%! assert (data.Z(order, :), Z(same, :));
%! assert (data.stage, repmat ({'gap'}, 4, 1));
%! % 4 runs of First, 1 of Second; the jam, the unlucky packing
%! assert ([count.stored, count.noResult], [5, 2]);

%!test
%! % rows of runs.csv with two effects on, or without a result, are kept
%! raw = standInCase (tempname ());
%! for model = {'First', 'Second'}
%!   head = fullfile (raw.folder, 'DEMmodels', model{1}, 'data.head');
%!   writeAtomic (head, [fileread(head), "variable b2 equal 1\n"]);
%! end
%! list = struct ('name', {'own', 'new'}, 'variables', {{'e'}, {'b2'}}, ...
%!                'neutral', {0, 1}, 'limits', [0.5; 5]);
%! Case = withEffects (newCase (raw), list);
%! writeAtomic (fullfile (Case.folder, 'runs.csv'), ...
%!   ["model,a,b,e,b2,First_1,First_2,Second_1\n", ...
%!    "First,1,2,,,3,2,\nFirst,1,2,3,4,6,5,\nFirst,2,2,,3,,NaN,\n"]);
%! [data, count] = gatherRuns (Case);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (Case.folder, 's');
%! assert (count.imported, 3);
%! assert ([data.X, data.E], [1, 2, 0, 1; 1, 2, 3, 4; 2, 2, 0, 3]);
%! assert (data.Z, [3, 2, NA; 6, 5, NA; NaN, NaN, NA]);

%!test
%! % a bench without a result takes no part, and no further run is spent on it;
%! % one that was never run to its end is said to be that
%! addpath (fileparts (which ('startToolbox')));
%! raw = standInCase (tempname ());
%! writeLoadInput (raw.folder, ['Input.maxNewRuns = 200; ', ...
%!                              'optim.targetStd = {[4, 0.001], 0.1};']);
%! writeAtomic (fullfile (raw.folder, 'loadEffects.m'), ...
%!   ["function effects = loadEffects ()\n", ...
%!    "effects = struct ('name', 'own', 'variables', {{'e'}}, ...\n", ...
%!    "                  'neutral', 0, 'limits', [0; 5]);\nend\n"]);
%! writeAtomic (fullfile (raw.folder, 'DEMmodels', 'Second', 'runscript'), ...
%!              "echo NaN > out\n");
%! words = [shellQuote(fullfile (raw.root, 'bin', 'decalioc')), ...
%!          ' diagnose ', raw.folder];
%! [~, out] = system ([words, ' 2>&1']);
%! assert (~isempty (strfind (out, 'as none of its runs gave a result: Second')), ...
%!         out);
%! n = cellfun (@(m) numel (listRunFolders (raw.folder, m)), ...
%!              {'First', 'Second'});
%! assert (n(1) > 12 && n(2) <= 24, sprintf ('%d ', n));
%! gap = readJsonFile (fullfile (raw.folder, 'gap', 'gap.json'));
%! assert ({gap.where.out, gap.where.neverRun}, {{'Second'}, []});
%! confirm_recursive_rmdir (false, 'local');
%! % without its runs, and without leave to make any
%! cellfun (@(name) rmdir (fullfile (raw.folder, 'optim', 'Second', name), ...
%!                         's'), listRunFolders (raw.folder, 'Second'));
%! writeLoadInput (raw.folder, ['Input.maxNewRuns = 0; ', ...
%!                              'optim.targetStd = {[4, 0.001], 0.1};']);
%! [~, out] = system ([words, ' 2>&1']);
%! assert (~isempty (strfind (out, 'as it was never run to its end: Second')), out);
%! gap = readJsonFile (fullfile (raw.folder, 'gap', 'gap.json'));
%! assert (gap.where.neverRun, {'Second'});
%! page = fileread (fullfile (raw.folder, 'results', 'report.html'));
%! assert (~isempty (strfind (page, 'as it was never run to its end')));

%!test
%! % more runs than surrogates hold: the diagnosis and the calibration take a
%! % part, say so, and the calibration says what is lost
%! addpath (fileparts (which ('startToolbox')));
%! raw = standInCase (tempname ());
%! writeLoadInput (raw.folder, ['Input.maxNewRuns = 0; ', ...
%!                              'optim.targetStd = {[0.1, 0.3], 0.1};']);
%! writeAtomic (fullfile (raw.folder, 'loadEffects.m'), ...
%!   ["function effects = loadEffects ()\n", ...
%!    "effects = struct ('name', 'own', 'variables', {{'e'}}, ...\n", ...
%!    "                  'neutral', 0, 'limits', [0; 5]);\nend\n"]);
%! rand ('twister', 1);
%! X = 10 * rand (1040, 2);
%! E = [zeros(1020, 1); 5 * rand(20, 1)];
%! sums = [sum(X, 2), prod(X, 2), X * [1; -1]] + E + 0.1 * rand (1040, 3);
%! table = [X, E, sums]';
%! writeAtomic (fullfile (raw.folder, 'runs.csv'), ...
%!   ["model,a,b,e,First_1,First_2,Second_1\n", ...
%!    sprintf("First,%.6g,%.6g,%.6g,%.6g,%.6g,\n", table(1:5, :)), ...
%!    sprintf("Second,%.6g,%.6g,%.6g,,,%.6g\n", table([1:3, 6], :))]);
%! program = shellQuote (fullfile (raw.root, 'bin', 'decalioc'));
%! [~, out] = system ([program, ' diagnose ', raw.folder, ' 2>&1']);
%! assert (~isempty (strfind (out, '1000 of 1040 runs are used')), out);
%! gap = readJsonFile (fullfile (raw.folder, 'gap', 'gap.json'));
%! assert (gap.which.verdict, 'no gap');
%! [~, out] = system ([program, ' run ', raw.folder, ' 2>&1']);
%! off = regexp (out, ['The 20 runs left out are off the surrogates by ', ...
%!                     '(\S+) % of the range at most'], 'tokens', 'once');
%! assert (str2double (off{1}) < 1);

% SPDX-License-Identifier: GPL-3.0-only
