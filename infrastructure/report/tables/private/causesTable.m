% CAUSESTABLE  Statement: how likely each cause is, and how strong it would be.
%
% CALL: T = causesTable (PAGE)
%
%   PAGE  see shownResult
%   T     see newTable, the likeliest first; [] without a diagnosis, and for a change
%         of one number, which tells no causes apart

function T = causesTable (page)
  T = [];
  which = jsonAt (page.sources.gap, {'which'});
  steps = [{'gap', 'which'}, repmat({'said'}, 1, isfield (which, 'said')), 'posterior'];
  posterior = jsonAt (page.sources, steps);
  if isempty (posterior) || jsonNumber (page.verdict.cause, {'numbers'}, 0) == 1
    return
  end
  [~, order] = sort (-cell2mat (struct2cell (posterior)));
  names = fieldnames (posterior)(order);
  groups = eachOf (@(g) {'cause.group'; plainName(cellstr (g)(:)')}, ...
                   jsonList (which, {'groups'}));
  notes = listSentences ([{'cause.siblings', plainName(unique (namesIn (which, 'siblings'))); ...
                           'cause.decides', namesIn(which, 'decides'); ...
                           'cause.partners', plainName(namesIn (which, 'partners'))}; ...
                          [groups{:}]']);
  T = newTable (page, 'causes', 'Causes, the likeliest first', ...
                {'cause', '', 'name'; 'probability', '', 'probability'; ...
                 'how strong it would be (90 % interval)', '', 'words'; ...
                 'seen from', '', ''}, eachOf (@(n) rowOf (page, which, n, steps), names), ...
                [jsonAt(page, {'verdict', 'cause', 'untested'}), notes, ...
                 {sentence('table.causesGiven', struct (), page.isChange), ...
                  sentence('table.causes')}(1 + isfield (posterior, 'null'):2)]);
end

function cells = rowOf (page, which, name, steps)
  entry = struct ('value', name, 'code', name);
  [how, from] = deal ('');
  if any (strcmp (name, {'null', 'unlisted'}))
    entry = sentence (['cause.', name, '.row'], struct (), page.isChange);
  else
    strength = jsonAt (which, {'strength', name});
    entry.value = givenField (strength, 'label', name);
    how = strengthWords (page, strength, name);
    from = char (jsonAt (strength, {'seenFrom'}));
  end
  cells = {entry, [steps, {name}], how, from};
end

% In its unit; the share of its range is the tooltip.
function c = strengthWords (page, strength, name)
  text = givenField (strength, 'amount', givenField (strength, 'text', ''));
  c = struct ('value', text, 'class', '', 'title', '');
  if any (strcmp (name, namesIn (page.verdict.cause, 'cannotSee')))
    c = struct ('value', sentence ('strength.unseen'), 'class', 'unsure');
  elseif strcmp (jsonAt (strength, {'says'}), 'nothing')
    c.value = sentence ('strength.unknown');
  elseif ~isempty (text)
    c.title = sprintf ('%.2g of its range', strength.value);
  end
end

%!test
%! page = situationPage ('missed, several');
%! T = causesTable (page);
%! assert (T.cells{1, 1}.code, 'cohesion');
%! assert (T.cells{1, 2}.value, 0.9);
%! assert (T.cells{1, 3}.value, 'cohesion 41 kJ/m3 (31 to 58)');
%! % one that is named has a strength, though weak ones would not be seen
%! page.sources.gap.which.cannotSee = {'cohesion'; 'drag'};
%! page.sources.gap.which.groups = {{'cohesion', 'liquidBridge'}};
%! page.verdict = decideCase (page.sources.calibration, page.sources.gap);
%! T = causesTable (page);
%! how = @(name) T.cells(cellfun (@(c) strcmp (givenField (c, 'code', ''), name), ...
%!                                T.cells(:, 1)), 3){1}.value;
%! assert (how ('cohesion'), 'cohesion 41 kJ/m3 (31 to 58)');
%! assert (how ('drag'), sentence ('strength.unseen'));
%! assert (! isempty (strfind ([T.notes{:}], 'liquid bridge')), [T.notes{:}]);
%! page.verdict.cause.untested = {'drag could not be tested'};
%! assert (causesTable (page).notes{1}, 'drag could not be tested');
%! % where a gap shows, causes are told given that there is one
%! page.sources.gap.which.said.posterior = struct ('cohesion', 0.95, 'unlisted', 0.05);
%! T = causesTable (page);
%! assert ({rows(T.cells), T.cells{1, 2}.value}, {2, 0.95});
%! assert (any (strcmp (T.notes, sentence ('table.causesGiven'))));
%! page.verdict.cause.numbers = 1;
%! assert (isempty (causesTable (page)));

% SPDX-License-Identifier: GPL-3.0-only
