% Other forms of mistakes that strangers have made, a line each of siblings.csv: kind, input
% (\n: a new line) and what is said of it ('' nothing). CASE stands for the case folder.
% Kinds: places that all runs share (a runscript, an input script), tables of runs, trials
% of measured.csv, LIGGGHTS scripts with coefficients that nothing reads or grains that may
% be lost, rigs of one's own named as a test rig of the toolbox, causes at the end of their
% range, cases of a table of runs without a model folder, test rigs at another setting than
% the words of their results say (rig, result, variable, value).

%!function list = of (kind, least = 15)
%!  file = fullfile (fileparts (which ('reportedCase')), 'siblings.csv');
%!  [~, cells] = readCsvTable (file);
%!  cells = cells(strcmp (cells(:, 1), kind), 2:3);
%!  list = [cellfun(@do_string_escapes, cells(:, 1), 'UniformOutput', false), cells(:, 2)];
%!  assert (rows (list) >= least);
%!endfunction
%!function places = sharedPlaces (text, file)
%!  folder = tempname ();
%!  model = fullfile (folder, 'DEMmodels', 'M');
%!  mkdir (model);
%!  writeAtomic (fullfile (model, 'runscript'), "#!/bin/bash\nliggghts -in in.M\n");
%!  first = repmat ("#!/bin/bash\n", 1, strcmp (file, 'runscript'));
%!  writeAtomic (fullfile (model, file), [first, text]);
%!  [~, ~, places] = namedFiles (model, fullfile (folder, 'optim', 'M', '0001'));
%!  places = strrep (strjoin (places, ' '), folder, 'CASE');
%!endfunction
%!function said = loaded (base, files)
%!  folder = reportedCase (base);
%!  for k = 1:2:numel (files)
%!    [~, ~] = mkdir (fileparts (fullfile (folder, files{k})));
%!    writeAtomic (fullfile (folder, files{k}), files{k + 1});
%!  end
%!  home = cd (folder);
%!  back = onCleanup (@() cd (home));
%!  clear ('loadInput');
%!  try
%!    said = loadCase (fileparts (which ('DEcalioc')), folder);
%!  catch err
%!    said = err.message;
%!  end
%!endfunction

%!function said = taken (Case)
%!  said = Case;
%!  if isstruct (Case)
%!    try
%!      t = importRuns (fullfile (Case.folder, 'runs.csv'), Case);
%!      said = sprintf ('%d rows, %d results: %.4g %.4g %.4g', rows (t.X), ...
%!                      sum (isfinite (t.Z(:))), t.X(1), t.Z(1, :));
%!    catch err
%!      said = err.message;
%!    end
%!  end
%!endfunction
%!function files = edited (base, text)
%!  files = {};
%!  for edit = strsplit (text, ' | ')
%!    part = regexp (edit{1}, '^(\S+): (.*?) ?=> (.*)$', 'tokens', 'once');
%!    new = part{3};
%!    if ! isempty (part{2})
%!      old = fileread (fullfile (fileparts (which ('reportedCase')), base, part{1}));
%!      new = strrep (old, part{2}, part{3});
%!      assert (! strcmp (old, new), edit{1});
%!    end
%!    files = [files, part(1), {new}];
%!  end
%!endfunction

%!test
%! for one = of ('writes outside')'
%!   assert (strcmp (sharedPlaces (one{1}, 'runscript'), one{2}), '%s', one{1});
%! end

%!test
%! for one = of ('writes outside (input script)')'
%!   assert (strcmp (sharedPlaces (one{1}, 'in.M'), one{2}), '%s', one{1});
%! end

%!test
%! for one = of ('table')'
%!   said = taken (loaded ('placeWithZero', {'runs.csv', one{1}}));
%!   assert (! isempty (strfind (said, one{2})), '%s: %s', one{1}, said);
%! end

%!test
%! for one = of ('trials')'
%!   text = ["model,name,value,sd,unit,tol,repeats,session\n", one{1}, ...
%!           "Slope,lean,5,0.05,mm,3%,,\n"];
%!   said = loaded ('unequalTrials', {'measured.csv', text});
%!   if isstruct (said)
%!     t = said.targets(1);
%!     said = sprintf ('%.4g +- %.4g, allowed %.4g', t.value, t.sd, halfWidth (t));
%!   end
%!   assert (! isempty (strfind (said, one{2})), '%s: %s', one{1}, said);
%! end

%!test
%! for one = of ('rig named as a bench', 13)'
%!   said = taken (loaded ('rigCalledHeap', edited ('rigCalledHeap', one{1})));
%!   assert (! isempty (strfind (said, one{2})), '%s: %s', one{1}, said);
%! end

%!test
%! for one = of ('runs of a table alone', 8)'
%!   Case = loaded ('reportWithoutModels', edited ('reportWithoutModels', one{1}));
%!   said = taken (Case);
%!   if isstruct (Case) && ! isempty (strfind (said, ' rows, '))
%!     said = sprintf ('%s, %s', said, caseStatus (Case, []).state);
%!   end
%!   assert (! isempty (strfind (said, one{2})), '%s: %s', one{1}, said);
%! end

%!test
%! root = fileparts (fileparts (which ('startToolbox')));
%! for one = of ('setting of a rig', 8)'
%!   part = strsplit (one{1}, ' ');
%!   info = resultInfo (fullfile (root, 'DEMmodels', part{1}), ...
%!                      struct (part{3}, str2double (part{4})));
%!   said = info(strcmp ({info.name}, part{2})).text;
%!   assert (! isempty (strfind (said, one{2})), '%s: %s', one{1}, said);
%! end

%!test
%! % of a diagnosis that names none: which effects closed the gap; which stand at their
%! % end; share closed
%! list = verdictCase ();
%! gap = list(strcmp ({list.name}, 'missed, none listed')).gap;
%! for one = of ('cause at its end', 8)'
%!   part = strsplit (one{1}, ';', 'CollapseDelimiters', false);
%!   own = gap;
%!   [own.howFar.effect, own.howFar.closure] = deal (part{1}, str2double (part{3}));
%!   for name = strsplit (part{2}, ',')(1:end * ! isempty (part{2}))
%!     own.which.strength.(name{1}).atEnd = '3 1/s';
%!   end
%!   cause = decideGap (jsondecode (jsonencode (own)));
%!   said = sprintf ('%s %s: %s', cause.code, strjoin (cause.todo.widen, ', '), ...
%!                   cause.sentence);
%!   assert (! isempty (strfind (said, one{2})), '%s: %s', one{1}, said);
%! end

%!test
%! % one case with a model for each
%! list = of ('script');
%! folder = tempname ();
%! models = arrayfun (@(k) sprintf ('M%02d', k), 1:rows (list), 'UniformOutput', false);
%! for k = 1:rows (list)
%!   place = fullfile (folder, 'DEMmodels', models{k});
%!   mkdir (fullfile (place, 'OctaveFuns'));
%!   put = @(name, text) writeAtomic (fullfile (place, name), text);
%!   put ('runscript', "#!/bin/bash\nliggghts -in in.x\n");
%!   put ('in.x', ["include data.head\n", list{k, 1}, "print \"${runSeed}\"\nrun 1\n"]);
%!   put ('data.head', "variable mu equal 1\nvariable rw equal 1\nvariable runSeed equal 1\n");
%!   put ('OctaveFuns/getResults.m', "function r = getResults (m, n)\nr = {NaN};\nend\n");
%! end
%! writeAtomic (fullfile (folder, 'loadInput.m'), strjoin ( ...
%!   {'function [Input, optim, modelVars, assign, paramLims] = loadInput ()', ...
%!    sprintf('Input.model = {%s};', strjoin (strcat ('''', models, ''''), ', ')), ...
%!    sprintf('Input.cpu = ones (1, %d); Input.maxCPU = 1; Input.numOfSam = 8;', rows (list)), ...
%!    sprintf('for k = 1:%d, optim.targetVal{k} = 1; optim.tolRes{k} = 0.1; end', rows (list)), ...
%!    'modelVars = struct (); assign = {''mu'', ''rw''}; paramLims = [0, 0; 2, 2];', ...
%!    'end', ''}, "\n"));
%! [~, out] = startCommand (folder, 'check');
%! for k = 1:rows (list)
%!   said = regexp (out, ['WARNING   ', models{k}, ': ([^\n]*)'], 'tokens');
%!   said = strjoin ([cell(1, 0), said{:}], ' ');
%!   if isempty (list{k, 2})
%!     assert (isempty (said), '%s', list{k, 1});
%!   else
%!     assert (! isempty (strfind (said, list{k, 2})), '%s: %s', list{k, 1}, [said, out]);
%!   end
%! end

% SPDX-License-Identifier: GPL-3.0-only
