% Flow of NEXT TEST: two causes that look alike on the benches of a case,
% another setting that parts them, its table filled in, and the name.

%!function put (folder, name, lines)
%!  writeAtomic (fullfile (folder, name), [strjoin(lines, "\n"), "\n"]);
%!endfunction
%!function model (folder, name, formulas)
%!  % awk: results of a, b, glue, wet and the opening w, with scatter
%!  place = fullfile (folder, 'DEMmodels', name);
%!  mkdir (fullfile (place, 'OctaveFuns'));
%!  put (place, 'data.head', strcat ({'variable '}, ...
%!       {'a equal 1', 'b equal 1', 'glue equal 0', 'wet equal 0', ...
%!        'w equal 1', 'runSeed equal 15485863'}));
%!  put (place, ['in.', name], {'# awk does the work'});
%!  put (place, 'runscript', {'awk -f law.awk data.head > out'});
%!  n = numel (formulas);
%!  prints = strcat ('  printf "%.9g\n", 0.03 * normal() + ', formulas);
%!  put (place, 'law.awk', ...
%!       [{'$1 == "variable" { v[$2] = $4 }', ...
%!         ['function normal() { return sqrt(-2 * log(rand() + 1e-12)) ', ...
%!          '* cos(6.2831853 * rand()) }'], ...
%!         'END { srand(v["runSeed"]); a = v["a"]; b = v["b"]; w = v["w"]', ...
%!         '  g = v["glue"]; s = g + v["wet"] * (2 - w)'}, prints, {'}'}]);
%!  names = arrayfun (@(k) sprintf ('%s%d', lower (name), k), 1:n, ...
%!                    'UniformOutput', false);
%!  put (place, 'results.csv', [{'name,kind,unit,series,at,text'}, ...
%!                              strcat(names, ',,,,,of the bench')]);
%!  put (place, 'OctaveFuns/getResults.m', ...
%!       {'function res = getResults (model, folderName)', 'global path', ...
%!        sprintf('res = repmat ({NaN}, 1, %d);', n), ...
%!        'file = [path, ''optim/'', model, ''/'', folderName, ''/out''];', ...
%!        'if exist (file, ''file'')', '  res = num2cell (load (file)'');', ...
%!        'end', 'end'});
%!endfunction
%!function z = law (a, b, s, w)
%!  z = {[a + 2 * s, b - s, a + b + 2 * s, a - b, 2 * a + 3 * s], ...
%!       [w * a + s, 2 * b - s * w, a + s + w]};
%!endfunction
%!function folder = newCaseFolder (isTable)
%!  folder = tempname ();
%!  model (folder, 'Cup', {'a + 2 * s', 'b - s', 'a + b + 2 * s', 'a - b', ...
%!                         '2 * a + 3 * s'});
%!  model (folder, 'Bin', {'w * a + s', '2 * b - s * w', 'a + s + w'});
%!  put (folder, 'DEMmodels/Bin/settings.csv', ...
%!       {'variable,unit,values,text', 'w,m,2 1.1,an opening of %s'});
%!  z = law (1.2, 2.1, 0.7, 1);
%!  lines = {['function [Input, optim, modelVars, assign, limits] = ', ...
%!            'loadInput ()'], ...
%!           'Input.model = {''Cup'', ''Bin''};', 'Input.cpu = [1, 1];', ...
%!           'Input.maxCPU = 2;', 'Input.numOfSam = 12;', ...
%!           'Input.maxNewRuns = 400;', 'Input.seed = 3;', ...
%!           'modelVars = struct ();', ...
%!           'assign = {''a'', ''b''};', 'limits = [0.5, 1; 2, 3];'};
%!  form = {sprintf('optim.targetVal = {%s, %s};', mat2str (z{1}), ...
%!                  mat2str (z{2})), 'optim.tolRes = 0.05;', ...
%!          'optim.targetStd = {0.02 * ones(1, 5), 0.02 * ones(1, 3)};', ...
%!          ['optim.targetName = {{''c1'', ''c2'', ''c3'', ''c4'', ', ...
%!           '''c5''}, {''b1'', ''b2'', ''b3''}};']};
%!  if isTable
%!    form = {'optim.tolRes = 0.05;'};
%!    rows_ = {'model,name,value,sd'};
%!    for k = 1:5
%!      rows_{end + 1} = sprintf ('Cup,cup%d,%.6g,0.02', k, z{1}(k));
%!    end
%!    for k = 1:3
%!      rows_{end + 1} = sprintf ('Bin,bin%d,%.6g,0.02', k, z{2}(k));
%!    end
%!    put (folder, 'measured.csv', rows_);
%!  end
%!  put (folder, 'loadInput.m', [lines, form, {'end'}]);
%!  effect = @(n) sprintf (['struct(''name'', ''%s'', ''variables'', ', ...
%!                          '{{''%s''}}, ''neutral'', 0, ''limits'', ', ...
%!                          '[0.01; 1.2])'], n, n);
%!  put (folder, 'loadEffects.m', {'function effects = loadEffects ()', ...
%!       ['effects = [', effect('glue'), ', ', effect('wet'), '];'], 'end'});
%!endfunction
%!function g = diagnosed (folder)
%!  root = fileparts (which ('DEcalioc'));
%!  [status, out, err] = startProgram (folder, ...
%!                         shellQuote (fullfile (root, 'diagnoseGap.m')));
%!  assert (err, '');
%!  assert (status == 0, out);
%!  g = jsondecode (fileread (fullfile (folder, 'gap', 'gap.json')));
%!  g.out = out;
%!endfunction
%!function fillIn (file, values)
%!  % three trials of each result
%!  lines = strsplit (strtrim (fileread (file)), "\n");
%!  for k = 1:numel (values)
%!    for trial = 1:3
%!      at = 4 + 3 * (k - 1) + trial;
%!      value = values(k) + 0.02 * (trial - 2);
%!      lines{at} = strrep (lines{at}, ',,,,', sprintf (',,,%.6g,', value));
%!    end
%!  end
%!  writeAtomic (file, [strjoin(lines, "\n"), "\n"]);
%!endfunction

%!test
%! % seeded; the two causes are alike on all targets of the case to the last
%! % digit, so it is a group; at w = 2 the wet one does nothing
%! folder = newCaseFolder (false);
%! g = diagnosed (folder);
%! assert (g.which.verdict, 'group');
%! assert (sort (g.which.effects)', {'glue', 'wet'});
%! best = g.next(1);
%! if iscell (best)
%!   best = best{1};
%! end
%! assert (best.model, 'Bin_w_2m');
%! assert ({best.variable, best.value, best.trials, best.runs}, ...
%!         {'w', 2, 3, 20});
%! assert (! isfield (best, 'isFirm'));
%! assert (best.gain > 0.6);
%! assert (sort (best.between)', {'glue', 'wet'});
%! words = 'measure Bin with an opening of 2 m';
%! assert (! isempty (strfind (g.out, [words, ', 3 trials: '])));
%! assert (! isempty (strfind (g.verdict.action, words)));
%! % nobody waits for it: the verdict is said before, and once more at the end
%! trying = strfind (g.out, 'press Ctrl-C');
%! causes = strfind (g.out, "\nCAUSE ");
%! assert ([numel(trying), numel(causes)], [1, 2]);
%! assert (causes(1) < trying && trying < causes(2));
%! assert (strfind (g.out, [words, ', 3 trials: '])(1) > trying);
%! % the other one was tried, not advised, and is gone
%! place = fullfile (folder, 'gap', 'next');
%! assert ({dir(fullfile (place, '*.csv')).name}, {'Bin_w_2m.csv'});
%! assert (! isfolder (fullfile (place, 'DEMmodels', 'Bin_w_1.1m')));
%! % its runs are found again as those of the new bench
%! runs = numel (listRunFolders (folder, 'Bin_w_2m'));
%! assert (runs, 20);
%! fillIn (fullfile (place, 'Bin_w_2m.csv'), law (1.2, 2.1, 0.7, 2){2});
%! g = diagnosed (folder);
%! assert (g.which.verdict, 'named');
%! assert (g.which.effects, {'glue'});
%! assert (any (strcmp ({g.where.models.model}, 'Bin_w_2m')));
%! % no set was run twice on a bench that had it
%! [~, out] = system (['grep -rho ''"key":"[0-9a-f]*"'' ', ...
%!                     shellQuote(fullfile (folder, 'optim')), ...
%!                     ' --include=record.json | sort | uniq -d']);
%! assert (out, '');
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');

%!test
%! % a case with measured.csv: the filled table joins it, an empty one does not
%! folder = newCaseFolder (true);
%! place = fullfile (folder, 'gap', 'next');
%! mkdir (fullfile (place, 'DEMmodels'));
%! copyfile (fullfile (folder, 'DEMmodels', 'Bin'), ...
%!           fullfile (place, 'DEMmodels', 'Bin_w_2m'));
%! file = fullfile (place, 'Bin_w_2m.csv');
%! put (place, 'Bin_w_2m.csv', ...
%!      {'# measure', 'model,name,series,at,value,sd,unit,tol', ...
%!       'Bin_w_2m,bin1,,,,,,0.05', 'Bin_w_2m,bin1,,,,,,0.05', ...
%!       'Bin_w_2m,bin3,,,,,,0.05'});
%! read = @() readInput (fileparts (which ('DEcalioc')), folder);
%! here = cd (folder);
%! back = onCleanup (@() cd (here));
%! clear loadInput
%! assert (numel (newCase (read ()).targets), 8);
%! text = fileread (file);
%! writeAtomic (file, strrep (text, ',bin1,,,,', ',bin1,,,3.1,'));
%! clear loadInput
%! Case = newCase (read ());
%! assert ({Case.models.name}, {'Cup', 'Bin', 'Bin_w_2m'});
%! assert (numel (Case.targets), 9);
%! assert ({Case.targets([6, 9]).name}, {'bin1', 'Bin_w_2m_bin1'});
%! assert ([Case.targets(9).value, Case.targets(9).trials], [3.1, 2]);
%! assert (Case.models(3).folder, fullfile (place, 'DEMmodels', 'Bin_w_2m'));
%! clear back loadInput
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');

%!test
%! % tables that name no model, as one is enough: runs.csv and measured.csv of
%! % the one model still hold when a test has joined it
%! folder = tempname ();
%! raw = standInCase (folder);
%! place = fullfile (folder, 'gap', 'next');
%! mkdir (fullfile (place, 'DEMmodels'));
%! rename (fullfile (folder, 'DEMmodels', 'Second'), ...
%!         fullfile (place, 'DEMmodels', 'First_x'));
%! writeLoadInput (folder, ['Input.model = {''First''}; Input.cpu = 1; ', ...
%!                          'optim = struct (''tolRes'', 0.1);']);
%! put (folder, 'measured.csv', {'name,value', 'slope,7', 'area,12'});
%! put (place, 'First_x.csv', {'model,name,value', 'First_x,slope,1'});
%! put (folder, 'runs.csv', {'a,b,slope,area', '1,2,3,4'});
%! for name = {'DEMmodels/First', 'gap/next/DEMmodels/First_x'}
%!   put (folder, [name{1}, '/results.csv'], ...
%!        [{'name,kind,unit,series,at,text', 'slope,,,,,'}, ...
%!         repmat({'area,,,,,'}, 1, strcmp (name{1}, 'DEMmodels/First'))]);
%! end
%! here = cd (folder);
%! back = onCleanup (@() cd (here));
%! clear loadInput
%! Case = loadCase (raw.root, folder);
%! assert ({Case.models.name}, {'First', 'First_x'});
%! assert ({Case.targets.name}, {'slope', 'area', 'First_x_slope'});
%! assert ([Case.targets.model], [1, 1, 2]);
%! assert (importRuns (fullfile (folder, 'runs.csv'), Case).Z(1:2), [3, 4]);
%! % the test says itself which model it is of
%! put (place, 'First_x.csv', {'name,value', 'slope,1'});
%! assert ([loadCase(raw.root, folder).targets.model], [1, 1, 2]);
%! assert (costInput ({}).value, [7; 12; 1]);
%! clear back loadInput
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');

% SPDX-License-Identifier: GPL-3.0-only
