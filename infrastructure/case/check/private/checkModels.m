% CHECKMODELS  Checks that every model folder is there, complete and can run.
%
% CALL: P = checkModels (MODELS, FOLDER, ROOT, HOW)
%
%   MODELS  1 x M struct array, see checkFindModels
%   FOLDER  case folder (text)
%   ROOT    folder of the toolbox (text)
%   HOW     scalar struct of booleans: onCluster (runs start on another machine:
%           programs are not looked for), programs (bash may be started)
%   P       1 x n faults, see checkFault
%
% bash reads the runscript (bash -n), nothing in it is run. Of the programs,
% liggghts, mpirun and mpiexec are looked for wherever they stand, any other
% where the script is one plain command, as in the user document.

function p = checkModels (models, folder, root, how)
  p = checkFault ();
  for k = find (~cellfun (@isempty, {models.name}))
    if isempty (models(k).folder)
      p = [p, missing(models(k).name, k, folder, root)];
    else
      p = [p, checkFolder(models(k)), checkFiles(models(k)), ...
           checkTables(models(k)), ...
           checkLeftovers(models(k).name, models(k).left)];
      if isfile (fullfile (models(k).folder, 'runscript'))
        p = [p, checkRunscript(models(k), how)];
      end
      p = [p, checkStages(models(k), {models.name}, how)];
    end
  end
end

function p = missing (name, k, folder, root)
  places = {fullfile(folder, 'DEMmodels'), fullfile(root, 'DEMmodels')};
  found = cellfun (@folderNames, places, 'UniformOutput', false);
  if any (strcmp (name, found{2}))       % but it declares none of the parameters
    p = checkFault ('missingModel', sprintf ('Input.model{%d}', k), ...
                    sprintf ('a folder %s', fullfile (places{1}, name)), 'none', ...
                    sprintf (['Copy the model folder there. %s of the toolbox, a ' ...
                              'test rig, declares none of the names of assign.'], name));
    return
  end
  cure = checkNearest (name, [found{:}]);
  if isempty (cure)
    cure = 'Copy the model folder there, or correct the name.';
  end
  if isfile (fullfile (folder, 'runs.csv'))
    cure = [cure, ' For the runs of runs.csv alone set Input.maxNewRuns = 0.'];
  end
  p = checkFault ('missingModel', sprintf ('Input.model{%d}', k), ...
                  sprintf ('a folder in %s or %s', places{:}), ...
                  [name, ', which is in neither'], cure);
end

function names = folderNames (place)
  names = setdiff (readdir (place), {'.', '..'})';
  names = names(cellfun (@(name) isfolder (fullfile (place, name)), names));
end

% The models that it starts from: complete but for getResults, and no circle. Those
% among NAMES are checked as models of the case.
function p = checkStages (model, names, how)
  p = checkFault ();
  field = ['DEMmodels/', model.name, '/startsFrom'];
  [stages, folders] = stagesOf (model.folder);
  for k = 1:numel (stages)
    stage = model;
    [stage.name, stage.folder, stage.message] = deal (stages{k}, folders{k}, '');
    if ~isKind ('folder', stages{k}) || ~isfolder (folders{k})
      p(end + 1) = checkFault ('missingStage', field, ...
                               'names of models beside it, one a line', ...
                               describeValue (stages{k}), ...
                               'Put that model there, or correct the name.');
    elseif any (strcmp (model.folder, ...
                        nthargout (2, @stagesOf, folders{k}, 'all')))
      p(end + 1) = checkFault ('stageCircle', field, ...
                               'models that do not start from this one', ...
                               stages{k}, 'Take the name out of one of them.');
    elseif exist (fullfile (model.folder, stages{k}), 'file')
      p(end + 1) = checkFault ('stageName', field, ...
                               ['no file of that name in the model: in a run ' ...
                                'the last state stands there'], stages{k}, ...
                               'Rename that file, or the model of that name.');
    elseif ~any (strcmp (stages{k}, names))
      stage.head = checkHead (stage.folder);
      q = [checkFolder(stage), checkFiles(stage)];
      if isfile (fullfile (stage.folder, 'runscript'))
        q = [q, checkRunscript(stage, how)];
      end
      q = [q, checkStages(stage, names, how)];
      if ~isempty (q)                            % Octave joins empty structs to []
        isResults = strcmp ({q.id}, 'DEcalioc:checkCase:missingGetResults');
        p = [p, q(~isResults)];
      end
    end
  end
end

% The folder of a run is no model. A link that leads nowhere is what cp -r makes
% of a relative one.
function p = checkFolder (model)
  p = checkFault ();
  field = ['DEMmodels/', model.name];
  traces = {'end.mark', 'record.json', 'job.json'};
  left = traces(isfile (fullfile (model.folder, traces)));
  if ~isempty (left)
    p = checkFault ('modelWithRun', field, 'a model, without a run in it', ...
                    ['the folder of a run (', strjoin(left, ', '), ')'], ...
                    ['Delete these files and the output of that run, or ' ...
                     'copy the model anew.']);
  end
  [~, answer] = system (['LC_ALL=C find -L ', shellQuote(model.folder), ...
                         ' -depth 2>&1 > /dev/null']);
  loop = regexp (answer, '^find: File system loop detected; ''(.*)'' is', ...
                 'tokens', 'once', 'lineanchors', 'dotexceptnewline');
  if ~isempty (loop)
    p(end + 1) = checkFault ('missingInputFile', field, ...
                             'files and folders that can be copied', ...
                             ['a link that leads back (', loop{1}, ')'], ...
                             'Remove that link.');
  end
  for name = readdir (model.folder)'
    path = fullfile (model.folder, name{1});
    if ~isempty (lstat (path)) && isempty (stat (path))
      p(end + 1) = checkFault ('missingInputFile', ...
                               [field, '/', name{1}], ...
                               'files that can be read', ...
                               'a link that leads nowhere', ...
                               'Copy the model with cp -rL.');
    end
  end
end

function p = checkFiles (model)
  field = @(name) ['DEMmodels/', model.name, '/', name];
  p = checkPlainText (fullfile (model.folder, 'data.head'), ...
                      field ('data.head'));
  inputs = glob (fullfile (regexprep (model.folder, '([][*?\\])', '\\$1'), 'in.*'))';
  for file = inputs
    p = [p, checkPlainText(file{1}, field (regexprep (file{1}, '^.*/', '')))];
  end
  lines = 'lines such as: variable densityP equal 700';
  call = 'a function res = getResults (model, folderName)';
  files = {'data.head', 'missingHead', lines, ...
           ['Declare every variable of the model there, and let in.Model ' ...
            'include it.']; ...
           'OctaveFuns/getResults.m', 'missingGetResults', call, ...
           ['Write it: it reads the files of a finished run and returns a ' ...
            'cell of numbers.']; ...
           'runscript', 'missingRunscript', ...
           'a bash script that starts the DEM run', ...
           'Write for example: liggghts < in.Model'};
  isThere = isfile (fullfile (model.folder, files(:, 1)));
  if isThere(1) && isempty (model.head) && isempty (p)
    p(end + 1) = checkFault ('emptyHead', field (files{1}), lines, ...
                             'a file without any such line', files{1, 4});
  end
  for k = find (~isThere)'
    p(end + 1) = checkFault (files{k, 2}, field (files{k, 1}), files{k, 3}, ...
                             'no such file', files{k, 4});
  end
  if isThere(2) && ~isempty (model.message)
    p(end + 1) = checkFault ('brokenGetResults', field (files{2}), call, ...
                             describeValue (model.message), ...
                             'Call it at the Octave prompt until it runs.');
  end
end

% Tables that nobody needs, but that are believed where they are there: a calibration
% reads the first two, a diagnosis the last, hours later.
function p = checkTables (model)
  p = checkFault ();
  readers = {@resultInfo, @runScatter, @readSettings};
  tables = {'results.csv', 'scatter.csv', 'settings.csv'};
  for k = find (isfile (fullfile (model.folder, tables)))
    try
      readers{k} (model.folder);
    catch err
      p(end + 1) = checkFault ('modelTable', ...
                               ['DEMmodels/', model.name, '/', tables{k}], ...
                               'a table as in docs/extend.md', ...
                               ['one that ends in: ', err.message], ...
                               'Correct the table, or remove it: no run needs it.');
    end
  end
end

function p = checkRunscript (model, how)
  field = ['DEMmodels/', model.name, '/runscript'];
  file = fullfile (model.folder, 'runscript');
  text = checkReadText (file);
  lines = commandLines (text);
  example = 'Write for example: liggghts < in.Model';
  [status, out] = deal (0, '');
  if how.programs
    [status, out] = system (['LC_ALL=C bash -n ', shellQuote(file), ' 2>&1']);
  end
  complaint = describeValue (strrep (strtok (out, "\n"), [file, ': '], ''));
  p = checkPlainText (file, field);
  table = {isempty(lines), 'emptyRunscript', 'a command', ...
           'a file without any', example; ...
           any(text == "\r"), 'windowsLineEnds', ...
           'lines that end in a line feed alone', 'Windows line ends', ...
           'Run: sed -i ''s/\r$//'' runscript'; ...
           any(text == 0), 'badRunscript', 'a bash script', ...
           'a binary file', example; ...
           status ~= 0, 'badRunscript', 'a script that bash can read', ...
           complaint, 'Try it with: bash -n runscript'};
  first = find ([table{:, 1}], 1);
  if isempty (p) && ~isempty (first)
    p = checkFault (table{first, 2}, field, table{first, 3:5});
  elseif isempty (p)
    p = checkRanks (field, lines, model.cpu);
    if ~how.onCluster
      p = [checkPrograms(field, lines), p];
    end
  end
end

% Lines that hold a command; a trailing comment is cut off.
function lines = commandLines (text)
  lines = strsplit (strrep (text, "\\\n", ' '), "\n");
  lines = strtrim (regexprep (lines, '(^|\s)#.*$', ''));
  lines = lines(~cellfun (@isempty, lines));
end

% What a longer script starts the first run tells. One that sets its PATH is left to it.
function p = checkPrograms (field, lines)
  p = checkFault ();
  text = strjoin (lines, "\n");
  setsPath = ['PATH=|module |source |\. /|command -v|which |type |hash |', ...
              'conda|spack'];
  words = strsplit (text, {' ', "\t", "\n", ';', '&', '|', '(', ')', '<', '>'});
  names = words(ismember (words, {'liggghts', 'mpirun', 'mpiexec'}));
  if isscalar (lines) && isempty (regexp (text, '[^\w\s.+/<-]', 'once'))
    names = setdiff ([names, {strtok(text, " \t<")}], shellWords ());
  end
  isLost = cellfun (@(n) isempty (file_in_path (getenv ('PATH'), n)) && ~any (n == '/'), ...
                    names);
  for name = unique (names(isLost & isempty (regexp (text, setsPath, 'once'))))
    cure = 'Install it, or write its full path.';
    if strcmp (name{1}, 'liggghts')
      cure = 'Build it with: make liggghts; or write the full path of yours.';
    end
    p(end + 1) = checkFault ('missingProgram', field, ...
                             ['a program ', name{1}, ' on the PATH'], 'none', cure);
  end
end

% What bash itself carries out.
function names = shellWords ()
  names = strsplit (['. alias bg break builtin caller cd command continue declare dirs ' ...
                     'disown echo enable eval exec exit export false fc fg getopts hash ' ...
                     'help history jobs kill let local logout mapfile popd printf pushd ' ...
                     'pwd read readarray readonly return set shift shopt source suspend ' ...
                     'test time times trap true type typeset ulimit umask unalias unset ' ...
                     'wait'], ' ');
end

% More ranks than CPUs are counted for share these with other runs, unseen.
function p = checkRanks (field, lines, cpu)
  p = checkFault ();
  n = regexp (lines, ...
              '\<(?:mpirun|mpiexec)\>.*\s(?:-n|-np|--np|-c)\s+(\d+)\s', ...
              'tokens', 'once');
  n = [n{:}];
  n = n(find (str2double (n) > cpu, 1));
  if ~isempty (n)
    p = checkFault ('rankMismatch', field, ...
                    sprintf ('at most Input.cpu = %d rank(s)', cpu), ...
                    ['mpirun with ', n{1}], ...
                    ['Set Input.cpu of this model to ', n{1}, '.']);
  end
end

%!shared model
%! model = struct ('name', 'First', 'head', 1, 'message', '', 'cpu', 1, ...
%!                 'folder', fullfile (standInCase (tempname ()).folder, ...
%!                                     'DEMmodels', 'First'), ...
%!                 'left', {cell(0, 3)});
%!assert (checkModels (struct ('name', {'Lft', ''}, 'folder', ''), ...
%!                     '/nowhere', '/nowhere', struct ()).id, ...
%!        'DEcalioc:checkCase:missingModel')
%!test
%! % the only model was renamed or deleted: the folder of models is empty
%! folder = emptyFolder ();
%! mkdir (fullfile (folder, 'DEMmodels'));
%! p = checkModels (struct ('name', 'Lft', 'folder', ''), folder, folder, struct ());
%! assert (p.id, 'DEcalioc:checkCase:missingModel');
%!test
%! table = {"# a comment\nawk 1 data.head > out", false, ''; ...
%!          'noSuchDEM < in.x', true, ''; ...
%!          "# nothing\n\n", false, 'emptyRunscript'; ...
%!          "if true; then\n", false, 'badRunscript'; ...
%!          "true\r\n", false, 'windowsLineEnds'; ...
%!          [char([239, 187, 191]), "awk 1 x"], false, 'badEncoding'; ...
%!          'noSuchDEM in.x', false, 'missingProgram'; ...
%!          'noSuchDEM < in.x', false, 'missingProgram'; ...
%!          'noSuchDEM $x', false, ''; ...
%!          'exit 3', false, ''; 'ulimit -s 8192', false, ''; ...
%!          'exec bin/noSuchDEM in.x', false, ''; ...
%!          'mpirun -np 4 liggghts -in x', true, 'rankMismatch'};
%! for row = table'
%!   writeAtomic (fullfile (model.folder, 'runscript'), row{1});
%!   p = checkModels (model, '', '', ...
%!                    struct ('programs', true, 'onCluster', row{2}));
%!   assert (isempty (p) == isempty (row{3}), row{1});
%!   assert (isempty (p) || strcmp (p(end).id(20:end), row{3}));
%! end
%!test
%! % a link to a folder above, of which no copy can be made
%! symlink ('..', fullfile (model.folder, 'OctaveFuns', 'again'));
%! p = checkModels (model, '', '', struct ('onCluster', true, 'programs', 0));
%! assert (~isempty (strfind (p(1).message, 'a link that leads back')));
%!test
%! % models that it starts from: not there, in a circle, with a file in their place,
%! % incomplete; getResults is asked of none of them
%! raw = standInCase (tempname ());
%! place = fullfile (raw.folder, 'DEMmodels');
%! model.folder = fullfile (place, 'First');
%! put = @(name, text) writeAtomic (fullfile (place, name), text);
%! how = struct ('onCluster', true, 'programs', 0);
%! ask = @() {checkModels(model, '', '', how).id};
%! put ('First/startsFrom', "Fill\n");
%! assert (ask (), {'DEcalioc:checkCase:missingStage'});
%! mkdir (fullfile (place, 'Fill'));
%! assert (ask (), {'DEcalioc:checkCase:missingHead', ...
%!                  'DEcalioc:checkCase:missingRunscript'});
%! put ('Fill/data.head', "variable a equal 1\n");
%! put ('Fill/runscript', "true\n");
%! assert (isempty (checkModels (model, '', '', how)));
%! put ('Fill/startsFrom', 'Second');
%! put ('Second/startsFrom', 'First');
%! assert (ask (), {'DEcalioc:checkCase:stageCircle'});
%! unlink (fullfile (place, 'Second', 'startsFrom'));
%! put ('First/Fill', '');
%! assert (ask (), {'DEcalioc:checkCase:stageName'});

% SPDX-License-Identifier: GPL-3.0-only
