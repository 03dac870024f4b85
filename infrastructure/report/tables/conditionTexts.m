% CONDITIONTEXTS  What has changed in each condition of a case, a line each.
%
% CALL: LIST = conditionTexts (GAP)
%
%   GAP   decoded gap/gap.json
%   LIST  1 x C struct name, effects, code ('named', 'likely', 'several'; 'open':
%         nothing is named), text (what has changed, with its interval; of
%         several 'A or B'), probability (of several: that it is one of them; NaN:
%         nothing is named), file ('' where no cause was fitted), line (name, text
%         and probability), the surest first; none for a case without conditions

function list = conditionTexts (gap)
  list = struct ('name', {}, 'effects', {}, 'code', {}, 'text', {}, 'probability', {}, ...
                 'file', {}, 'line', {});
  % the files of the one that leads lie in gap/ itself
  place = givenField (jsonAt (gap, {'reference'}), 'folder', 'gap');
  for one = jsonList (gap, {'reference', 'conditions'})
    if ~isempty (list)
      place = ['gap/', one{1}.name];
    end
    list(end + 1) = textsOf (one{1}, [place, '/calibrated.head']);
  end
  p = [list.probability];
  p(isnan (p)) = -1;
  [~, order] = sort (-p);
  list = list(order);
end

function entry = textsOf (one, file)
  effects = namesIn (one, 'effects');
  texts = namesIn (one, 'text');
  texts(end + 1:numel (effects)) = effects(numel (texts) + 1:end);
  told = givenField (one, 'said', one);
  p = [jsonAt(told, {'probability'})(:)', NaN];
  if isfield (one, 'names')
    % those that may be said
    isSaid = ismember (effects, namesIn (one, 'names'));
    [effects, texts, p] = deal (effects(isSaid), texts(isSaid), p([isSaid, true]));
  end
  entry = struct ('name', one.name, 'effects', {effects}, 'code', 'named', ...
                  'text', strjoin (texts, ' and '), ...
                  'probability', max (p), 'file', file, 'line', '');
  if strcmp (one.code, 'likely')
    entry.code = one.code;
  elseif strcmp (one.verdict, 'group')
    % which one is open, and so is how strong
    [entry.code, entry.text] = deal ('several', strjoin (plainName (effects), ' or '));
    entry.probability = jsonNumber (told, {'oneOf'}, min (1, sum (p(1:end - 1))));
  end
  % a cause that cannot be seen is listed, and not said
  if isempty (effects) || any (strcmp (one.kind, {'cannot tell', 'no verdict'}))
    entry.text = givenField (one, 'plain', '');
    if isempty (entry.text)
      entry.text = sentence (['cause.', codeOf(one), '.word'], struct (), true);
    end
    [entry.code, entry.probability, entry.file] = deal ('open', NaN, '');
  end
  values = struct ('name', entry.name, 'text', entry.text, ...
                   'p', plainNumber (entry.probability, 'probability'));
  entry.line = sentence (['condition.', entry.code], values);
  change = givenField (one, 'change', '');
  if ~isempty (change)
    % first what has changed, then by what
    values = struct ('name', entry.name, 'change', change, ...
                     'cause', entry.line(numel (entry.name) + 3:end));
    entry.line = sentence ('condition.change', values);
  end
end

% A diagnosis that was broken off leaves a verdict without a code.
function code = codeOf (one)
  code = one.code;
  if isempty (code)
    code = merge (strcmp (one.verdict, 'no gap'), 'none', 'open');
  end
end

%!test
%! assert (isempty (conditionTexts (struct ('reference', []))));
%! gap.reference.conditions = struct ('name', {'dry', 'wet'}, 'verdict', ...
%!   {'no gap', 'named'}, 'code', {'none', 'named'}, 'kind', {'none', 'found'}, ...
%!   'effects', {{}, {'cohesion'}}, 'probability', {[], 0.9}, ...
%!   'text', {{}, {'cohesion 4 kJ/m3'}});
%! list = conditionTexts (gap);
%! assert ({list.name}, {'wet', 'dry'});
%! assert ({list.file}, {'gap/wet/calibrated.head', ''});
%! assert (list(2).text, sentence ('cause.none.word', struct (), true));
%! assert (list(1).line, 'wet: cohesion 4 kJ/m3, probability 0.90');
%! gap.reference.conditions(1).code = '';
%! assert (conditionTexts (gap)(2).text, sentence ('cause.none.word', struct (), true));
%! % what the verdict on a condition says is said here, too
%! gap.reference.conditions(1).code = 'mixed';
%! gap.reference.conditions(1).kind = 'cannot tell';
%! assert (conditionTexts (gap)(2).line, 'dry: These tests cannot tell');
%! gap.reference.conditions = struct ('name', 'wet', 'verdict', 'group', ...
%!   'code', 'several', 'kind', 'several', ...
%!   'effects', {{'cohesion', 'tilt'}}, 'probability', [0.7, 0.2], ...
%!   'text', {{'cohesion 4 kJ/m3', 'tilt 3 deg'}});
%! assert (conditionTexts (gap).line, ...
%!         sentence ('condition.several', struct ('name', 'wet', 'p', '0.90', ...
%!           'text', 'cohesion or tilt')));
%! gap.reference.conditions.said = struct ('probability', [0.75, 0.2], 'oneOf', 0.95);
%! assert (conditionTexts (gap).probability, 0.95);
%! gap.reference.conditions = rmfield (gap.reference.conditions, 'said');
%! % what it may not name is left out; the change comes first
%! gap.reference.conditions.names = {'cohesion'};
%! gap.reference.conditions.code = 'likely';
%! gap.reference.conditions.change = 'Changed: slope.';
%! list = conditionTexts (gap);
%! assert ({list.text, list.probability}, {'cohesion 4 kJ/m3', 0.7});
%! assert (strncmp (list.line, 'wet: Changed: slope. Likely cohesion', 35), list.line);

% SPDX-License-Identifier: GPL-3.0-only
