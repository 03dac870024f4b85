% CHECKDECLARED  Checks that the models take the variables that are set.
%
% CALL: P = checkDeclared (NAMES, FIELDS, KINDS, MODELS)
%
%   NAMES   1 x n cell, names of variables that are written into data.head
%   FIELDS  1 x n cell, how the user writes each, e.g. 'assign{2}'
%   KINDS   1 x n cell: 'design', 'fixed' or 'effect'
%   MODELS  1 x M struct array, see checkFindModels
%   P       1 x m faults, see checkFault
%
% A variable must be declared by the data.head of at least one model, with the
% style equal: LIGGGHTS stops at a variable that changes its style. The
% properties that the Rayleigh time takes may be fixed without a declaration.
% No input script may set a variable anew below the line that includes
% data.head: what is written there would be lost.
%
% Reasons: unknownVariable variableStyle overwrittenInScript

function p = checkDeclared (names, fields, kinds, models)
  p = checkFault ();
  models = models(~cellfun (@isempty, {models.folder}));
  for k = 1:numel (models)
    p = [p, checkStyles(names, fields, models(k)), ...
         checkScripts(names, fields, models(k))];
  end
  if isempty (models) || any (cellfun (@isempty, {models.head}))
    return
  end
  head = [models.head];
  known = unique ({head.name});
  free = {'radiusP', 'densityP', 'youngsModulusP', 'poissonsRatioP', ...
          'percentRayleigh'};
  for k = find (~ismember (names, known))
    if ~(strcmp (kinds{k}, 'fixed') && any (strcmp (names{k}, free)))
      p = [p, unknown(names{k}, fields{k}, known, models)];
    end
  end
end

function p = unknown (name, field, known, models)
  cure = checkNearest (name, known);
  if isempty (cure)
    cure = 'Declare it there, and use it in the input script.';
  end
  where = strjoin (strcat ('DEMmodels/', {models.name}, '/data.head'), ' or ');
  p = checkFault ('unknownVariable', field, ...
                  ['a variable that ', where, ' declares'], name, cure);
end

function p = checkStyles (names, fields, model)
  p = checkFault ();
  for k = 1:numel (model.head)
    place = find (strcmp (model.head(k).name, names), 1);
    style = model.head(k).style;
    if ~isempty (place) && ~strcmp (style, 'equal')
      p(end + 1) = checkFault ('variableStyle', fields{place}, ...
                               sprintf (['a variable of style equal in ' ...
                                         'DEMmodels/%s/data.head'], ...
                                        model.name), ...
                               ['variable ', names{place}, ' ', style], ...
                               'Write there: variable NAME equal VALUE');
    end
  end
end

function p = checkScripts (names, fields, model)
  p = checkFault ();
  files = glob (fullfile (escape (model.folder), 'in.*'))';
  for k = 1:numel (files)
    [~, base, ext] = fileparts (files{k});
    again = setBelow (checkReadText (files{k}));
    for i = find (ismember (names, again))
      p(end + 1) = checkFault ('overwrittenInScript', fields{i}, ...
                               sprintf (['no line that sets it below ' ...
                                         'include data.head in %s'], ...
                                        ['DEMmodels/', model.name, '/', ...
                                         base, ext]), ...
                               ['variable ', names{i}, ' equal ...'], ...
                               'Move that line to data.head.');
    end
  end
end

% Variables set anew below the include; x = f (x) changes a unit and is fine.
function names = setBelow (text)
  names = cell (1, 0);
  place = regexp (text, '^[ \t]*include[ \t]+data\.head', 'lineanchors', ...
                  'once');
  if isempty (place)
    return
  end
  found = regexp (text(place:end), ...
                  '^[ \t]*variable[ \t]+(\w+)[ \t]+equal[ \t]+([^#\n]*)', ...
                  'tokens', 'lineanchors');
  for k = 1:numel (found)
    [name, value] = found{k}{:};
    if isempty (strfind (value, ['{', name, '}'])) && ...
        isempty (strfind (value, ['v_', name]))
      names{end + 1} = name;
    end
  end
end

function path = escape (path)
  path = regexprep (path, '([][*?\\])', '\\$1');
end

%!shared model
%! head = struct ('name', {'densityP', 'mu', 'kind'}, ...
%!                'style', {'equal', 'equal', 'string'}, 'value', '1');
%! model = struct ('name', 'Toy', 'folder', '/nowhere', 'head', head);
%!assert (isempty (checkDeclared ({'mu'}, {'assign{1}'}, {'design'}, model)))
%!assert (isempty (checkDeclared ({'radiusP'}, {'modelVars.radiusP'}, ...
%!                                {'fixed'}, model)))
%!test
%! p = checkDeclared ({'Mu', 'kind'}, {'assign{1}', 'assign{2}'}, ...
%!                    {'design', 'design'}, model);
%! assert ({p.id}, strcat ('DEcalioc:checkCase:', ...
%!         {'variableStyle', 'unknownVariable'}));
%! assert (! isempty (strfind (p(2).message, 'Did you mean mu?')));
%!test
%! folder = tempname ();
%! mkdir (folder);
%! fid = fopen (fullfile (folder, 'in.Toy'), 'w');
%! fputs (fid, ["include data.head\nvariable densityP equal 7\n", ...
%!              "variable mu equal ${mu}*2\n"]);
%! fclose (fid);
%! model.folder = folder;
%! p = checkDeclared ({'mu', 'densityP'}, {'a', 'b'}, ...
%!                    {'design', 'fixed'}, model);
%! assert ({p.id}, {'DEcalioc:checkCase:overwrittenInScript'});
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
