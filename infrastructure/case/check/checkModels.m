% CHECKMODELS  Checks that every model folder is there and complete.
%
% CALL: P = checkModels (MODELS, FOLDER, ROOT, HOW)
%
%   MODELS  1 x M struct array, see checkFindModels
%   FOLDER  case folder (text)
%   ROOT    folder of the toolbox (text)
%   HOW     scalar struct, see checkRunscript
%   P       1 x n faults, see checkFault
%
% Reasons: missingModel modelWithRun missingInputFile missingHead emptyHead
% missingRunscript missingGetResults brokenGetResults, and those of
% checkRunscript

function p = checkModels (models, folder, root, how)
  p = checkFault ();
  for k = find (~cellfun (@isempty, {models.name}))
    if isempty (models(k).folder)
      p = [p, missing(models(k).name, k, folder, root)];
    else
      p = [p, checkFolder(models(k)), checkHeadFile(models(k)), ...
           checkEvaluation(models(k)), checkStart(models(k), how)];
    end
  end
end

function p = missing (name, k, folder, root)
  there = [folderNames(fullfile (folder, 'DEMmodels')), ...
           folderNames(fullfile (root, 'DEMmodels'))];
  cure = checkNearest (name, there);
  if isempty (cure)
    cure = 'Copy the model folder there, or correct the name.';
  end
  p = checkFault ('missingModel', sprintf ('Input.model{%d}', k), ...
                  sprintf ('a folder in %s or %s', ...
                           fullfile (folder, 'DEMmodels'), ...
                           fullfile (root, 'DEMmodels')), ...
                  sprintf ('%s, which is in neither', name), cure);
end

function names = folderNames (folder)
  names = cell (1, 0);
  if isfolder (folder)
    entries = dir (folder);
    names = {entries([entries.isdir]).name};
    names = names(~strncmp (names, '.', 1));
  end
end

% What a run leaves behind would be taken for the result of the next one. A
% link that leads nowhere is what cp -r makes of a relative one.
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
  loop = regexp (answer, ...
                 '^find: File system loop detected; ''([^\n]*)'' is', ...
                 'tokens', 'once', 'lineanchors');
  if ~isempty (loop)
    p(end + 1) = checkFault ('missingInputFile', field, ...
                             'files and folders that can be copied', ...
                             sprintf ('a link that leads back (%s)', ...
                                      loop{1}), 'Remove that link.');
  end
  names = readdir (model.folder);
  for k = 1:numel (names)
    path = fullfile (model.folder, names{k});
    if ~isempty (lstat (path)) && isempty (stat (path))
      p(end + 1) = checkFault ('missingInputFile', ...
                               [field, '/', names{k}], ...
                               'files that can be read', ...
                               'a link that leads nowhere', ...
                               'Copy the model with cp -rL.');
    end
  end
end

function p = checkHeadFile (model)
  p = checkFault ();
  field = ['DEMmodels/', model.name, '/data.head'];
  expected = 'lines such as: variable densityP equal 700';
  cure = ['Declare every variable of the model there, and let in.Model ' ...
          'include it.'];
  if ~isfile (fullfile (model.folder, 'data.head'))
    p = checkFault ('missingHead', field, expected, 'no such file', cure);
  elseif isempty (model.head)
    p = checkFault ('emptyHead', field, expected, ...
                    'a file without any such line', cure);
  end
end

function p = checkEvaluation (model)
  p = checkFault ();
  field = ['DEMmodels/', model.name, '/OctaveFuns/getResults.m'];
  expected = 'a function res = getResults (model, folderName)';
  if ~isfile (fullfile (model.folder, 'OctaveFuns', 'getResults.m'))
    p = checkFault ('missingGetResults', field, expected, ...
                    'no such file', ...
                    ['Write it: it reads the files of a finished run and ' ...
                     'returns a cell of numbers.']);
  elseif ~isempty (model.message)
    p = checkFault ('brokenGetResults', field, expected, ...
                    checkShow (model.message), ...
                    'Call it at the Octave prompt until it runs.');
  end
end

function p = checkStart (model, how)
  file = fullfile (model.folder, 'runscript');
  if ~isfile (file)
    p = checkFault ('missingRunscript', ...
                    ['DEMmodels/', model.name, '/runscript'], ...
                    'a bash script that starts the DEM run', ...
                    'no such file', ...
                    'Write for example: liggghts < in.Model');
    return
  end
  p = checkRunscript (model, how);
end

%!test
%! m = struct ('name', {'Lft', ''}, 'folder', '', 'head', [], 'message', '');
%! p = checkModels (m, '/nowhere', '/nowhere', struct ());
%! assert ({p.id}, {'DEcalioc:checkCase:missingModel'});
%!test
%! % a link to a folder above, of which no copy can be made
%! raw = standInCase (tempname ());
%! folder = fullfile (raw.folder, 'DEMmodels', 'First');
%! symlink ('..', fullfile (folder, 'OctaveFuns', 'again'));
%! m = struct ('name', 'First', 'folder', folder, 'head', 1, 'message', '');
%! p = checkModels (m, raw.folder, raw.root, ...
%!                  struct ('onCluster', true, 'programs', false));
%! assert (~isempty (strfind (p(1).message, 'a link that leads back')));
%!test
%! m = struct ('name', 'x', 'folder', '/nowhere', 'head', [], 'message', '');
%! p = checkModels (m, '/nowhere', '/nowhere', struct ());
%! assert ({p.id}, strcat ('DEcalioc:checkCase:', ...
%!         {'missingHead', 'missingGetResults', 'missingRunscript'}));
