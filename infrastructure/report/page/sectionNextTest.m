% SECTIONNEXTTEST  Part of the report: which further test would tell most.
%
% CALL: [TITLE, HTML] = sectionNextTest (PAGE), see writePage and pageData

function [title, html] = sectionNextTest (page)
  title = 'Next test';
  html = '';
  tests = jsonAt (page.sources.gap, {'next'});
  n = min (numel (tests), 10);
  if n < 1
    return
  end
  cells = cell (n, 3);
  for k = 1:n
    cells(k, :) = {htmlText(jsonAt (tests, {k, 'test'})), ...
                   pageNumber(page, 'plain', 'gap', 'next', k, 'gain'), ...
                   pageNumber(page, 'plain', 'gap', 'next', k, 'cost')};
  end
  gain = jsonAt (tests, {1, 'gain'});
  word = 'would tell most about the cause';
  if isnumeric (gain) && gain < 0.2
    word = ['would tell most, though little: a test of another kind ', ...
            '(another speed, opening or bench) may tell more'];
  end
  html = ['<p>Of what can be measured next, the first ', word, '.</p>', ...
          htmlTable('Further measurements, the best first', ...
                    {'test', 'how much it tells (1: a sure yes or no)', ...
                     'cost'}, cells)];
end

%!test
%! page = situationPage ('missed, named');
%! [~, html] = sectionNextTest (page);
%! text = regexprep (html, '(<[^>]*>|\s)+', ' ');
%! assert (! isempty (strfind (text, 'would tell most, though little')));
%! assert (! isempty (strfind (text, 'measure First once more 0.04 1')));
