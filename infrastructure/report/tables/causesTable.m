% CAUSESTABLE  Statement: how likely each cause is, and how strong it would be.
%
% CALL: T = causesTable (PAGE)
%
%   PAGE  see shownResult
%   T     see newTable, the likeliest first; [] without a diagnosis

function T = causesTable (page)
  T = [];
  which = jsonAt (page.sources.gap, {'which'});
  posterior = jsonAt (which, {'posterior'});
  if isempty (posterior)
    return
  end
  names = fieldnames (posterior)';
  [~, order] = sort (-cellfun (@(n) posterior.(n), names));
  cells = cellfun (@(n) rowOf (page, which, n), names(order), 'UniformOutput', false);
  notes = {};
  lists = {'cause.siblings', unique(namesIn (which, 'siblings')); ...
           'cause.decides', namesIn(which, 'decides'); ...
           'cause.partners', namesIn(which, 'partners')};
  for k = 1:numel (jsonAt (which, {'groups'}))
    lists(end + 1, :) = {'cause.group', cellstr(jsonAt (which, {'groups', k}))(:)'};
  end
  for one = lists(~cellfun (@isempty, lists(:, 2)), :)'
    notes{end + 1} = sentence (one{1}, struct ('names', {one{2}}));
  end
  T = newTable (page, 'causes', 'Causes, the likeliest first', ...
                {'cause', '', 'name'; 'probability', '', 'probability'; ...
                 'how strong it would be (90 % interval)', '', 'words'; ...
                 'seen from', '', ''}, vertcat (cells{:}), ...
                [jsonAt(page, {'verdict', 'cause', 'untested'}), notes, ...
                 {sentence('table.causes')}]);
end

function cells = rowOf (page, which, name)
  codes = struct ('null', 'cause.null', 'unlisted', 'cause.unlisted');
  own = struct ('value', name, 'code', '');
  [how, from] = deal ('');
  if isfield (codes, name)
    own.value = sentence ([codes.(name), '.row'], struct (), page.isChange);
  else
    own.code = name;
    strength = jsonAt (which, {'strength', name});
    label = jsonAt (strength, {'label'});
    if ~isempty (label)
      own.value = label;
    end
    how = strengthWords (which, strength, name);
    from = char (jsonAt (strength, {'seenFrom'}));
  end
  cells = {own, {'gap', 'which', 'posterior', name}, how, from};
end

% In its unit; the share of its range is the tooltip, and all that older files
% have.
function c = strengthWords (which, strength, name)
  c = struct ('value', '', 'class', '', 'title', '');
  text = jsonAt (strength, {'amount'});
  if isempty (text)
    text = jsonAt (strength, {'text'});
  end
  if any (strcmp (name, namesIn (which, 'cannotSee')))
    c = struct ('value', sentence ('strength.unseen'), 'class', 'unsure');
  elseif strcmp (jsonAt (strength, {'says'}), 'nothing')
    c.value = sentence ('strength.unknown');
  elseif ~isempty (text)
    c.value = text;
    c.title = sprintf ('%.2g of its range', strength.value);
  elseif ~isempty (jsonAt (strength, {'value'}))
    c.value = sprintf ('%.2f of its range (%.2f to %.2f)', strength.value, ...
                       strength.interval90);
  end
end

%!test
%! page = situationPage ('missed, several');
%! T = causesTable (page);
%! assert (T.cells{1, 1}.code, 'cohesion');
%! assert (T.cells{1, 2}.value, 0.9);
%! assert (T.cells{1, 3}.value, 'cohesion 41 kJ/m3 (31 to 58)');
%! page.sources.gap.which.cannotSee = {'cohesion'};
%! assert (causesTable (page).cells{1, 3}.value, sentence ('strength.unseen'));
%! page.verdict.cause.untested = {'drag could not be tested'};
%! assert (causesTable (page).notes{1}, 'drag could not be tested');
