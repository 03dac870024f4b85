% SECTIONSETTINGS  Part of the report: settings, versions, how to repeat it.
%
% CALL: [TITLE, HTML] = sectionSettings (PAGE), see writePage and pageData

function [title, html] = sectionSettings (page)
  title = 'Settings and how to repeat it';
  Case = page.Case;
  word = 'run';
  if ~isempty (page.sources.gap) && isempty (page.sources.calibration)
    word = 'diagnose';
  end
  html = ['<p>The same case with the same seed asks for the same runs ', ...
          'again, and takes those in the store: <code>decalioc ', word, ...
          '</code> in the case folder.</p>', warningsOf(page), ...
          modelTable(page), variableTable(Case), optionTable(page), ...
          fileList(page)];
end

function html = warningsOf (page)
  html = '';
  texts = cellstr (jsonAt (page.sources.calibration, {'warnings'}));
  texts = texts(~cellfun (@isempty, texts));
  if ~isempty (texts)
    items = cellfun (@(t) ['<li>', htmlText(t), '</li>'], texts(:)', ...
                     'UniformOutput', false);
    html = ['<h3>Warnings</h3><ul>', items{:}, '</ul>'];
  end
end

function html = modelTable (page)
  models = page.Case.models;
  cells = cell (numel (models), 4);
  for k = 1:numel (models)
    key = jsonAt (page.sources.calibration, {'input', 'models', k, 'key'});
    if ~ischar (key) || isempty (key)
      key = '-';
    end
    % no path of this machine: the page is mailed
    folder = strrep (models(k).folder, page.Case.folder, 'case');
    folder = strrep (folder, page.Case.root, 'DEcalioc');
    if isempty (folder)
      folder = 'none: imported runs';
    end
    cells(k, :) = {htmlText(models(k).name), sprintf('%d', models(k).cpu), ...
                   ['<code>', htmlText(folder), '</code>'], ...
                   ['<code>', key(1:min (end, 16)), '</code>']};
  end
  html = htmlTable ('Models (key: hash of input files, CPUs, program)', ...
                    {'model', 'CPUs a run', 'folder', 'key'}, cells);
end

function html = variableTable (Case)
  html = '';
  names = fieldnames (Case.modelVars);
  if isempty (names)
    return
  end
  cells = cell (numel (names), 2);
  for k = 1:numel (names)
    cells(k, :) = {htmlText(names{k}), numberText(Case.modelVars.(names{k}))};
  end
  html = htmlTable ('Model variables that are fixed', ...
                    {'variable', 'value'}, cells);
end

function html = optionTable (page)
  options = page.Case.options;
  names = fieldnames (options);
  cells = cell (0, 2);
  for k = 1:numel (names)
    value = options.(names{k});
    if ischar (value)
      cells(end + 1, :) = {names{k}, htmlText(value)};
    elseif isnumeric (value) && isscalar (value)
      text = strrep (sprintf ('%g', value), 'Inf', 'no limit');
      cells(end + 1, :) = {names{k}, text};
    end
  end
  version = jsonAt (page.sources.calibration, {'version'});
  if ischar (version)
    cells(end + 1, :) = {'version of DEcalioc', htmlText(version)};
  end
  cells(end + 1, :) = {'Octave', htmlText(OCTAVE_VERSION ())};
  html = htmlTable ('Options', {'option', 'value'}, cells);
end

function html = fileList (page)
  files = {'results/calibration.json', 'the result for other programs'; ...
           'results/calibrated.head', ...
           'lines of a data.head with the calibrated parameters'; ...
           'results/posterior.csv', 'a sample of the sets that fit'; ...
           'results/sensitivity.csv', ...
           'share of each response that each parameter makes'; ...
           'results/correlation.csv', 'of the parameters'; ...
           'results/runTable.csv', 'every run'; ...
           'gap/gap.json', 'the diagnosis for other programs'; ...
           'gap/calibrated.head', ...
           'parameters fitted together with the effect'; ...
           'Octave_logfile.txt', 'all that was said'};
  items = '';
  for k = 1:rows (files)
    if isfile (fullfile (page.Case.folder, files{k, 1}))
      items = [items, '<li><code>', files{k, 1}, '</code>: ', ...
               files{k, 2}, '</li>'];
    end
  end
  html = '';
  if ~isempty (items)
    html = ['<h3>Files in the case folder</h3><ul>', items, '</ul>'];
  end
end

%!test
%! page = situationPage ('met');
%! [~, html] = sectionSettings (page);
%! text = regexprep (html, '(<[^>]*>|\s)+', ' ');
%! assert (! isempty (strfind (text, 'First 1 case/DEMmodels/First ab')));
%! assert (isempty (strfind (html, page.Case.folder)));
