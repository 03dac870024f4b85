% SECTIONSENSITIVITY  Part of the report: which parameter moves which target.
%
% CALL: [TITLE, HTML] = sectionSensitivity (PAGE), see writePage and pageData

function [title, html] = sectionSensitivity (page)
  title = 'Sensitivity';
  html = '';
  share = jsonAt (page.sources.calibration, {'sensitivity'});
  names = page.Case.names;
  if ~isstruct (share) || ~all (isfield (share, names))
    return
  end
  shown = shownTargets (page.Case);
  cells = cell (numel (names), numel (shown) + 1);
  for j = 1:numel (names)
    cells{j, 1} = htmlText (names{j});
    for i = 1:numel (shown)
      t = shown(i);
      cells{j, i + 1} = pageNumber (page, 'probability', 'calibration', ...
                                    'sensitivity', names{j}, t);
      if share.(names{j})(t) >= 0.3
        cells{j, i + 1} = ['<strong>', cells{j, i + 1}, '</strong>'];
      end
    end
  end
  targets = cellfun (@htmlText, {page.Case.targets(shown).name}, ...
                     'UniformOutput', false);
  html = ['<p>Share of the variance of each response over the box that a ', ...
          'parameter makes, alone and with others.</p>', ...
          htmlTable('Share of the variance', [{'parameter'}, targets], cells)];
end

%!test
%! page = situationPage ('met');
%! [~, html] = sectionSensitivity (page);
%! text = regexprep (html, '(<[^>]*>|\s)+', ' ');
%! assert (! isempty (strfind (text, 'sum product difference a 0.50')));
%! assert (numel (strfind (html, '<strong>')), 6);
