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
  heads = [models.head];
  known = unique ({heads.name});
  free = {'radiusP', 'densityP', 'youngsModulusP', 'poissonsRatioP', ...
          'percentRayleigh'};
  isFree = strcmp (kinds, 'fixed') & ismember (names, free);
  places = strjoin (strcat ('DEMmodels/', {models.name}, '/data.head'), ' or ');
  for k = find (~ismember (names, known) & ~isFree)
    cure = checkNearest (names{k}, known);
    if isempty (cure)
      cure = ['Declare it there, and use it in the input script.', ofToolbox(models)];
    end
    p(end + 1) = checkFault ('unknownVariable', fields{k}, ...
                             ['a variable that ', places, ' declares'], ...
                             names{k}, cure);
  end
end

function p = checkStyles (names, fields, model)
  p = checkFault ();
  for line = model.head
    place = find (strcmp (line.name, names), 1);
    if ~isempty (place) && ~strcmp (line.style, 'equal')
      p(end + 1) = checkFault ('variableStyle', fields{place}, ...
                               ['a variable of style equal in DEMmodels/', ...
                                model.name, '/data.head'], ...
                               ['variable ', line.name, ' ', line.style], ...
                               'Write there: variable NAME equal VALUE');
    end
  end
end

function p = checkScripts (names, fields, model)
  p = checkFault ();
  pattern = regexprep (model.folder, '([][*?\\])', '\\$1');
  for file = glob (fullfile (pattern, 'in.*'))'
    [~, base, ext] = fileparts (file{1});
    for i = find (ismember (names, setBelow (checkReadText (file{1}))))
      p(end + 1) = checkFault ('overwrittenInScript', fields{i}, ...
                               ['no line that sets it below include ' ...
                                'data.head in DEMmodels/', model.name, ...
                                '/', base, ext], ...
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

%!shared model, reasons
%! head = struct ('name', {'densityP', 'mu', 'kind'}, ...
%!                'style', {'equal', 'equal', 'string'}, 'value', '1');
%! model = struct ('name', 'Toy', 'folder', tempname (), 'head', head);
%! reasons = @(p) strrep ({p.id}, 'DEcalioc:checkCase:', '');
%!assert (isempty (checkDeclared ({'mu'}, {'assign{1}'}, {'design'}, model)))
%!assert (isempty (checkDeclared ({'radiusP'}, {'modelVars.radiusP'}, ...
%!                                {'fixed'}, model)))
%!test
%! p = checkDeclared ({'Mu', 'kind'}, {'assign{1}', 'assign{2}'}, ...
%!                    {'design', 'design'}, model);
%! assert (reasons (p), {'variableStyle', 'unknownVariable'});
%! assert (! isempty (strfind (p(2).message, 'Did you mean mu?')));
%!test
%! mkdir (model.folder);
%! writeAtomic (fullfile (model.folder, 'in.Toy'), ...
%!              ["include data.head\nvariable densityP equal 7\n", ...
%!               "variable mu equal ${mu}*2\n"]);
%! p = checkDeclared ({'mu', 'densityP'}, {'a', 'b'}, ...
%!                    {'design', 'fixed'}, model);
%! assert (reasons (p), {'overwrittenInScript'});

% SPDX-License-Identifier: GPL-3.0-only
