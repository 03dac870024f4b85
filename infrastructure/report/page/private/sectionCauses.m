% SECTIONCAUSES  Parts of the report: which cause explains the gap; what has
% changed from the reference.
%
% CALL: LIST = sectionCauses (), see writePage

function list = sectionCauses ()
  list = {'sectionwhich', {'What the model lacks', 'What may have changed'}, @causes, ...
          {'sources', 'gap', 'which', 'posterior'}; ...
          'sectionchange', 'What has changed', @change, ...
          {'sources', 'gap', 'reference'}};
end

function html = causes (page)
  which = page.sources.gap.which;
  cause = page.verdict.cause;
  told = givenField (which, 'said', which).posterior;
  [~, order] = sort (-cell2mat (struct2cell (told)));
  posterior = orderfields (told, order);
  reached = levelText (page.sources.gap);
  if ~isempty (reached)
    reached = ['The verdict was ', reached];
  end
  said = {cause.sentence, cause.closed, madeByText(page.sources.gap, cause), reached};
  html = ['<p><strong>', htmlText(cause.word), '</strong>. ', ...
          htmlText(strjoin (said(~cellfun (@isempty, said)), ' ')), '</p>'];
  if ~isempty (page.tables.causes)
    html = [html, shapes(page, posterior), tableHtml(page.tables.causes)];
  end
end

% The measured gap, or change, and what each of the likeliest causes would make of it.
function html = shapes (page, posterior)
  prints = jsonAt (page.sources.gap, {'fingerprint'});
  names = jsonList (prints, {'targets'});
  % the likeliest first
  known = fieldnames (posterior)';
  known = known(isfield (jsonAt (prints, {'effects'}), known) & ...
                ~ismember (known, page.verdict.cause.cannotSee))(1:min (3, end));
  if strcmp (page.verdict.cause.kind, 'none') || isempty (names) || isempty (known)
    html = htmlFigures (bars (page, posterior));
    return
  end
  n = numel (names);
  y = (n:-1:1)';
  measured = prints.measured(:);
  what = merge (page.isChange, 'change', 'gap');
  f = newFigure (['Measured ', what, ', and what each cause would explain'], ...
                 'times the noise', names, ...
                 ['The measured ', what, ' and that of ', strjoin(plainName (known), ', ')], ...
                 {'box', [0 * y, y, min(0, measured), max(0, measured), ...
                          y - 0.36, y + 0.36], 'grey'; ...
                  'line', [0, 0.4; 0, n + 0.6], 'ink'});
  f.size = [360, 74 + 22 * n];
  symbols = {'diamond', 'blue'; 'triangle', 'amber'; 'ring', 'red'};
  symbols = symbols(1:numel (known), :);
  marks = eachOf (@(name) [prints.effects.(name)(:), y], known);
  f.layers = [f.layers; symbols(:, 1), marks(:), symbols(:, 2)];
  why = sentence ('figure.causes', struct (), page.isChange);
  html = ['<p>', htmlText(why), '</p>', ...
          htmlFigures([f, bars(page, posterior)], ...
                      [{'box', 'grey', ['measured ', what]}; ...
                       symbols, htmlText(plainName (known))'])];
end

function f = bars (page, posterior)
  p = cell2mat (struct2cell (posterior));
  n = min (numel (p), max (6, sum (p >= 0.005)));
  y = (n:-1:1)';
  names = fieldnames (posterior)';
  labels = plainName (names);
  for name = {'null', 'unlisted'}
    labels(strcmp (names, name{1})) = {sentence(['cause.', name{1}, '.row'], ...
                                                struct (), page.isChange)};
  end
  f = newFigure ('Probability of each cause', 'probability', labels(1:n), ...
                 sprintf ('%s is likeliest, probability %.2f', labels{1}, p(1)), ...
                 {'box', [0 * y, y, 0 * y, p(1:n), y - 0.32, y + 0.32], 'blue'});
  f.size = [340, 54 + 22 * n];
  f.xlim = [0, 1];
end

function html = change (page)
  reference = page.sources.gap.reference;
  words = givenField (reference, 'canChange', struct ());
  names = fieldnames (words)';
  of = @(word) names(strcmp (struct2cell (words)', word));
  lack = plainNumber (jsonAt (reference, {'lack'}), 'percent');
  notes = [{sentence('change.what', struct ('name', reference.condition, 'lack', lack))}, ...
           listSentences({'change.unlikely', plainName(of ('unlikely')); ...
                          'change.no', plainName(of ('no'))})];
  notes = strcat ('<p>', htmlText (notes), '</p>');
  % first that of the condition that leads, which has all other tables
  names = sort (fieldnames (page.tables))';
  tables = eachOf (@(name) tableHtml (page.tables.(name)), ...
                   names(strncmp (names, 'change', 6)));
  html = [tableHtml(page.tables.conditions), notes{:}, tables{:}];
end

%!test
%! % before, after, what was modelled; another condition and the order
%! page = situationPage ('missed, named');
%! page.sources.gap.reference = struct ('condition', 'wet', 'lack', 0.1, ...
%!   'targets', struct ('model', 'B', 'name', 'h', 'reference', 1, ...
%!                      'measured', 3, 'modelled', 2), ...
%!   'conditions', struct ('name', {'wet', 'dry'}, 'verdict', ...
%!                         {'named', 'no gap'}, 'code', {'named', 'none'}, ...
%!                         'kind', {'found', 'none'}, 'effects', {{'tilt'}, {}}), ...
%!   'order', struct ('effect', 'tilt', 'more', 'wet', 'less', 'dry', ...
%!                    'probability', 0.9), ...
%!   'canChange', struct ('tilt', 'yes', 'sizeSpread', 'unlikely', 'fill', 'no'));
%! page.tables = statementTables (page, {'change', 'conditions'});
%! html = sectionCauses (){2, 3} (page);
%! assert (! isempty (strfind (html, '+1')));
%! assert (! isempty (strfind (html, 'of the grains): size spread.')));
%! assert (! isempty (strfind (html, 'to have changed: fill.')));
%! assert (! isempty (strfind (html, sentence ('cause.none.word', struct (), true))));
%! assert (! isempty (strfind (html, 'More tilt in wet than in dry')));
%! % each condition has its table
%! page.tables.change_dry = setfield (page.tables.change, 'title', 'reference and dry');
%! html = sectionCauses (){2, 3} (page);
%! assert (! isempty (regexp (html, 'reference and wet.*reference and dry')), html);
%!test
%! % plain names in the figures; of one number neither figure nor table
%! page = situationPage ('missed, several');
%! which = page.sources.gap.which;
%! which.posterior.liquidBridge = 0.3;
%! page.sources.gap.which = which;
%! causes = sectionCauses (){1, 3};
%! page.tables = statementTables (page, {'causes'});
%! html = causes (page);
%! assert (! isempty (strfind (html, '>liquid bridge</text>')), html);
%! assert (! isempty (strfind (html, '<table>')));
%! page.verdict.cause.numbers = 1;
%! page.tables = statementTables (page, {'causes'});
%! html = causes (page);
%! assert (isempty (regexp (html, '<table>|<figure>', 'once')), html);

% SPDX-License-Identifier: GPL-3.0-only
