% SECTIONCAUSES  Parts of the report: which cause explains the gap; what has
% changed from the reference.
%
% CALL: LIST = sectionCauses (), see writePage

function list = sectionCauses ()
  list = {'sectionwhich', 'What the model lacks', @causes, ...
          {'sources', 'gap', 'which', 'posterior'}; ...
          'sectionchange', 'What has changed', @change, ...
          {'sources', 'gap', 'reference'}};
end

function html = causes (page)
  posterior = page.sources.gap.which.posterior;
  cause = page.verdict.cause;
  [~, order] = sort (-cellfun (@(n) posterior.(n), fieldnames (posterior)));
  posterior = orderfields (posterior, order);
  level = jsonAt (page.sources.gap, {'level'});
  if isstruct (level)
    level = ['The verdict was ', levelText(level)];
  end
  said = {cause.sentence, cause.closed, ...
          madeByText(jsonAt (page.sources.gap.which, {'cause'})), char(level)};
  html = ['<p><strong>', htmlText(cause.word), '</strong>. ', ...
          htmlText(strjoin (said(~cellfun (@isempty, said)), ' ')), '</p>', ...
          shapes(page, posterior), tableHtml(page.tables.causes)];
end

% The measured gap beside what each of the likeliest causes would make of it.
function html = shapes (page, posterior)
  html = htmlFigures (bars (page, posterior));
  if strcmp (page.verdict.cause.kind, 'none')
    return
  end
  prints = jsonAt (page.sources.gap, {'fingerprint'});
  names = jsonAt (prints, {'targets'});
  if isempty (names)
    return
  end
  known = setdiff (fieldnames (prints.effects), page.verdict.cause.cannotSee);
  chance = cellfun (@(name) max ([jsonAt(posterior, {name}), 0]), known);
  [~, order] = sort (-chance);
  known = known(order(1:min (3, end)))(:)';
  n = numel (names);
  y = (n:-1:1)';
  measured = prints.measured(:);
  f = newFigure ('The measured gap', 'in sd of the noise', ...
                 cellstr (names), 'The measured gap', ...
                 {'box', [0 * y, y, min(0, measured), max(0, measured), ...
                          y - 0.36, y + 0.36], 'grey'; ...
                  'line', [0, 0.4; 0, n + 0.6], 'ink'});
  f.size = [360, 74 + 22 * n];
  symbols = {'diamond', 'blue'; 'triangle', 'amber'; 'ring', 'red'};
  key = {'box', 'grey', 'measured gap'};
  for k = 1:numel (known)
    f.layers(end + 1, :) = {symbols{k, 1}, ...
                            [prints.effects.(known{k})(:), y], symbols{k, 2}};
    key(end + 1, :) = {symbols{k, :}, htmlText(known{k})};
  end
  why = '';
  if ~isempty (known)
    f.title = 'The gap, and what causes would make of it';
    f.alt = ['The measured gap beside that of ', strjoin(known, ', ')];
    why = ['<p>A cause explains the gap where its symbols stand at the ', ...
           'ends of the bars; two causes look alike where their symbols ', ...
           'lie on each other.</p>'];
  end
  html = [why, htmlFigures([f, bars(page, posterior)], key)];
end

function f = bars (page, posterior)
  p = vertcat (struct2cell (posterior){:});
  p = p(1:min (end, max (6, sum (p >= 0.005))));
  n = numel (p);
  labels = labelsOf (page, posterior)(1:n);
  y = (n:-1:1)';
  f = newFigure ('Probability of each cause', 'probability', labels, ...
                 sprintf ('%s is likeliest, probability %.2f', labels{1}, ...
                          p(1)), ...
                 {'box', [0 * y, y, 0 * y, p, y - 0.32, y + 0.32], 'blue'});
  f.size = [340, 54 + 22 * n];
  f.xlim = [0, 1];
end

function labels = labelsOf (page, posterior)
  labels = fieldnames (posterior)';
  for name = {'null', 'unlisted'}
    labels(strcmp (labels, name{1})) = {sentence(['cause.', name{1}, '.row'], struct (), ...
                                                 page.isChange)};
  end
end

function html = change (page)
  reference = page.sources.gap.reference;
  html = [tableHtml(page.tables.conditions), ...
          '<p>The measurements of <b>', htmlText(reference.condition), ...
          '</b> beside those of the reference. What the model lacks in ', ...
          'both drops out. Its likely size, in shares of what the parameters ', ...
          'move: ', pageNumber(page, 'percent', 'gap', 'reference', 'lack'), '.</p>', ...
          beforehand(reference), ...
          tableHtml(page.tables.change)];
end

% What the user, or the library, took for likely beforehand.
function html = beforehand (reference)
  html = '';
  words = jsonAt (reference, {'canChange'});
  if isempty (words)
    return
  end
  names = fieldnames (words);
  what = {'unlikely', ['Taken as unlikely to have changed, as properties of ', ...
                       'the grains']; ...
          'no', 'Taken as not changed'};
  for one = what'
    own = names(strcmp (struct2cell (words), one{1}));
    if ~isempty (own)
      html = [html, '<p>', one{2}, ': ', htmlText(strjoin (own', ', ')), ...
              '. (<code>canChange</code> in loadEffects.m.)</p>'];
    end
  end
end

%!test
%! % before, after, what was modelled; another condition and the order
%! page = situationPage ('missed, named');
%! page.sources.gap.reference = struct ('condition', 'wet', 'lack', 0.1, ...
%!   'targets', struct ('model', 'B', 'name', 'h', 'reference', 1, ...
%!                      'measured', 3, 'modelled', 2), ...
%!   'conditions', struct ('name', {'wet', 'dry'}, 'verdict', ...
%!                         {'named', 'no gap'}, 'effects', {{'tilt'}, {}}), ...
%!   'order', struct ('effect', 'tilt', 'more', 'wet', 'less', 'dry', ...
%!                    'probability', 0.9), ...
%!   'canChange', struct ('tilt', 'yes', 'rolling', 'unlikely', 'fill', 'no'));
%! page.tables = statementTables (page, {'change', 'conditions'});
%! html = sectionCauses (){2, 3} (page);
%! assert (! isempty (strfind (html, '+1')));
%! assert (! isempty (strfind (html, 'of the grains: rolling.')));
%! assert (! isempty (strfind (html, 'not changed: fill.')));
%! assert (! isempty (strfind (html, sentence ('cause.none.word', struct (), true))));
%! assert (! isempty (strfind (html, 'More tilt in wet than in dry')));
