% CHECKFINDMODELS  Looks up what the checks need to know of each model.
%
% CALL: MODELS = checkFindModels (INPUT, FOLDER, ROOT, MODE)
%
%   INPUT   scalar struct, the Input of loadInput
%   FOLDER  case folder (text)
%   ROOT    folder of the toolbox (text)
%   MODE    'full', or 'noPrograms': getResults is not called
%   MODELS  1 x M struct array: name; folder ('' where there is none, or the
%           name is not usable); head (see checkHead); cpu (NaN where not
%           usable); count (number of results, NaN where not known); message
%           (why getResults cannot be used, or ''); fields (names of the results
%           where it returns a struct)
%
% See also: checkModels, checkDryRun

function models = checkFindModels (Input, folder, root, mode)
  names = modelNames (Input);
  models = struct ('name', names, 'folder', '', 'head', [], 'cpu', NaN, ...
                   'count', NaN, 'message', '', 'fields', {{}});
  for k = 1:numel (models)
    if ~isempty (names{k})
      models(k).folder = findModel (names{k}, folder, root);
    end
    if ~isempty (models(k).folder)
      models(k).head = checkHead (models(k).folder);
      if strcmp (mode, 'full')
        [models(k).count, models(k).message, models(k).fields] = ...
          checkDryRun (models(k).folder, names{k});
      end
    end
    if isfield (Input, 'cpu') && checkIs ('vector', Input.cpu) && ...
        numel (Input.cpu) >= k
      models(k).cpu = double (Input.cpu(k));
    end
  end
end

function names = modelNames (Input)
  names = cell (1, 0);
  if ~isfield (Input, 'model')
    return
  end
  names = Input.model;
  if ischar (names)
    names = {names};
  end
  if ~iscell (names) || ~isvector (names)
    names = cell (1, 0);
    return
  end
  names = names(:)';
  for k = 1:numel (names)
    if ~checkIs ('text', names{k}) || ~checkFolderName (names{k})
      names{k} = '';
    end
  end
end

%!test
%! Input = struct ('model', {{'NoSuchModel', '../x', 3}}, 'cpu', [1, 2]);
%! m = checkFindModels (Input, '/nowhere', '/nowhere', 'full');
%! assert ({m.name}, {'NoSuchModel', '', ''});
%! assert ([m.cpu], [1, 2, NaN]);
%! assert (isnan ([m.count]), true (1, 3));
%!assert (isempty (checkFindModels (struct (), '/nowhere', '/nowhere', 'full')))
