% SETTINGSTABLE  Statement: what the case was run with.
%
% CALL: T = settingsTable (PAGE)
%
%   PAGE  see shownResult
%   T     see newTable: models with the key of their input, fixed model variables,
%         options, versions

function T = settingsTable (page)
  Case = page.Case;
  c = page.sources.calibration;
  numbers = cellfun (@(x) isnumeric (x) && isscalar (x), struct2cell (Case.options));
  texts = cellfun (@ischar, struct2cell (Case.options));
  names = fieldnames (Case.options);
  versions = {{'version', 'DEcalioc', char(jsonAt (c, {'version'}))}, ...
              {'version', 'Octave', OCTAVE_VERSION()}};
  T = newTable (page, 'settings', 'Models, fixed model variables, options, versions', ...
                {'kind', '', ''; 'name', '', ''; 'value', '', ''}, ...
                [eachOf(@(k) modelRow (Case, c, k), 1:numel (Case.models)), ...
                 eachOf(@(n) {'model variable', n, Case.modelVars.(n)}, ...
                        fieldnames (Case.modelVars)), ...
                 eachOf(@(n) {'option', n, optionText(Case.options.(n))}, ...
                        names(numbers | texts)), ...
                 versions(1 + ~ischar (jsonAt (c, {'version'})):end)]);
end

function cells = modelRow (Case, c, k)
  model = Case.models(k);
  key = char (jsonAt (c, {'input', 'models', k, 'key'}));
  % no path of this machine: the page is mailed
  folder = strrep (strrep (model.folder, Case.folder, 'case'), Case.root, 'DEcalioc');
  folder = [folder, repmat('none: imported runs', 1, isempty (folder))];
  cells = {'model', model.name, sprintf('%d CPU, %s, input %s', model.cpu, folder, ...
                                        key(1:min (end, 16)))};
end

function text = optionText (value)
  text = value;
  if isequal (value, Inf)
    text = sentence ('table.noLimit');
  elseif isnumeric (value)
    text = sprintf ('%g', value);
  end
end

%!test
%! T = settingsTable (situationPage ('met'));
%! names = cellfun (@(c) c.value, T.cells(:, 2)', 'UniformOutput', false);
%! assert (all (ismember ({'First', 'seed', 'Octave'}, names)));
%! assert (! isempty (strfind (T.cells{1, 3}.value, 'case/DEMmodels/First, input ab')));

% SPDX-License-Identifier: GPL-3.0-only
