% SETTINGSTABLE  Statement: what the case was run with.
%
% CALL: T = settingsTable (PAGE)
%
%   PAGE  see shownResult
%   T     see newTable: models with the key of their input, fixed model variables,
%         options, versions

function T = settingsTable (page)
  Case = page.Case;
  cells = cell (0, 3);
  for k = 1:numel (Case.models)
    model = Case.models(k);
    key = char (jsonAt (page.sources.calibration, {'input', 'models', k, 'key'}));
    % no path of this machine: the page is mailed
    folder = strrep (strrep (model.folder, Case.folder, 'case'), Case.root, 'DEcalioc');
    if isempty (folder)
      folder = 'none: imported runs';
    end
    cells(end + 1, :) = {'model', model.name, ...
                         sprintf('%d CPU, %s, input %s', model.cpu, folder, ...
                                 key(1:min (end, 16)))};
  end
  for name = fieldnames (Case.modelVars)'
    cells(end + 1, :) = {'model variable', name{1}, Case.modelVars.(name{1})};
  end
  for name = fieldnames (Case.options)'
    value = Case.options.(name{1});
    if isequal (value, Inf)
      value = sentence ('table.noLimit');
    elseif isnumeric (value) && isscalar (value)
      value = sprintf ('%g', value);
    end
    if ischar (value)
      cells(end + 1, :) = {'option', name{1}, value};
    end
  end
  version = jsonAt (page.sources.calibration, {'version'});
  if ischar (version)
    cells(end + 1, :) = {'version', 'DEcalioc', version};
  end
  cells(end + 1, :) = {'version', 'Octave', OCTAVE_VERSION()};
  T = newTable (page, 'settings', 'Models, fixed model variables, options, versions', ...
                {'kind', '', ''; 'name', '', ''; 'value', '', ''}, cells);
end

%!test
%! T = settingsTable (situationPage ('met'));
%! names = cellfun (@(c) c.value, T.cells(:, 2)', 'UniformOutput', false);
%! assert (all (ismember ({'First', 'seed', 'Octave'}, names)));
%! assert (! isempty (strfind (T.cells{1, 3}.value, 'case/DEMmodels/First, input ab')));
