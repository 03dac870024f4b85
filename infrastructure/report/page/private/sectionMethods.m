% SECTIONMETHODS  Part of the report: methods for a paper, and the record of the
% result.
%
% CALL: LIST = sectionMethods (), see writePage

function list = sectionMethods ()
  list = {'sectionmethods', 'Methods and record', @methods, {}};
end

function html = methods (page)
  c = page.sources.calibration;
  gap = page.sources.gap;
  html = '';
  if isempty (c) && isempty (gap)
    return
  end
  texts = {};
  if ~isempty (c)
    d = c.demRuns;
    misses = page.verdict.misses;
    values = struct ('names', {page.Case.names}, ...
                     'n', sum (strcmp ({misses.role}, 'calibrate')), ...
                     'models', {{page.Case.models.name}}, ...
                     'version', char (jsonAt (c, {'version'})), ...
                     'runs', d.plan + d.infill + d.verify, 'others', otherRuns (c), ...
                     'confirmed', jsonNumber(c, {'runs'}, 0), ...
                     'confidence', page.Case.options.confidence * 100, ...
                     'reason', c.reason);
    texts{end + 1} = sentence ('methods.calibration', values);
  end
  if ~isempty (gap)
    names = setdiff (fieldnames (gap.which.posterior)', {'null', 'unlisted'}, 'stable');
    values = struct ('names', {names}, 'verdict', page.verdict.cause.sentence, ...
                     'how', judgedHow (jsonAt (gap, {'howFar'})));
    texts{end + 1} = sentence ('methods.diagnosis', values);
  end
  texts = strcat ('<p>', htmlText (texts), '</p>');
  html = ['<h3>For a paper</h3>', texts{:}, '<p>', htmlText(sentence ('methods.sources')), ...
          '</p>', tableHtml(page.tables.record)];
end

% ', with 60 runs that were imported and 12 of other cases'.
function text = otherRuns (c)
  counts = cellfun (@(name) jsonNumber (c, {'sources', name}, 0), ...
                    {'imported', 'otherCases'});
  parts = {sprintf('%s imported', countText (counts(1), 'run')), ...
           sprintf('%s of other cases', countText (counts(2), 'run'))};
  joints = {', with ', ' and '};
  text = strjoin ([{''}, parts(counts > 0)], joints(1:sum (counts > 0)));
end

%!test
%! page = situationPage ('missed, named');
%! page.tables = statementTables (page, {'record'});
%! html = sectionMethods (){3} (page);
%! for text = {'Rackl', 'a, b', '3 results', 'cohesion', 'Record of this result'}
%!   assert (! isempty (strfind (html, text{1})), text{1});
%! end
%! page.sources.calibration.sources = struct ('imported', 60, 'otherCases', 1);
%! assert (! isempty (strfind (sectionMethods (){3} (page), ...
%!   'in all, with 60 runs imported and 1 run of other cases')));
%! page = situationPage ('nothing');
%! assert (sectionMethods (){3} (page), '');

% SPDX-License-Identifier: GPL-3.0-only
