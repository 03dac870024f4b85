% SECTIONPARAMETERS  Parts of the report: parameters and how well they are
% known; which parameter drives which result.
%
% CALL: LIST = sectionParameters (), see writePage

function list = sectionParameters ()
  list = {'sectionparameters', 'Values of the parameters', @parameters, {}; ...
          'sectionsensitivity', 'Sensitivity', ...
          @(page) tableHtml (page.tables.sensitivity), ...
          {'sources', 'calibration', 'sensitivity'}};
end

function html = parameters (page)
  html = '';
  c = page.sources.calibration;
  if isempty (c) && ~isempty (page.sources.gap)
    return
  end
  T = page.tables.parameters;
  if ~isempty (c)
    T.title = 'With what is known of each';      % the heading says the rest
  end
  html = [tableHtml(T), toCopy(page, c)];
end

% The lines that go into a model.
function html = toCopy (page, c)
  file = fullfile (page.Case.folder, 'results', 'calibrated.head');
  html = '';
  if isempty (c) || ~isfile (file)
    return
  end
  folders = {page.Case.models.folder};
  folders = folders(~cellfun (@isempty, folders));
  lines = unique (cellfun (@(f) propertyLines (f, c.params), folders, ...
                           'UniformOutput', false), 'stable');
  text = strsplit ([fileread(file), lines{:}], "\n");
  html = ['<details class="open" open><summary>To copy into a model</summary><pre>', ...
          strjoin(htmlText (text), "\n"), '</pre></details>'];
end

%!test
%! % the words of each parameter; without a calibration the limits
%! parameters = sectionParameters (){1, 3};
%! page = situationPage ('met, one parameter open');
%! page.tables = statementTables (page);
%! html = parameters (page);
%! assert (! isempty (strfind (html, '>fixed: by sum')));
%! assert (! isempty (strfind (html, '>not determined: ')));
%! page = situationPage ('nothing');
%! page.tables = statementTables (page);
%! assert (! isempty (strfind (parameters (page), 'Limits in which')));

% SPDX-License-Identifier: GPL-3.0-only
