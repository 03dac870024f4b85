% PARAMETERSTABLE  Statement: the values of the parameters, and how well they are
% known.
%
% CALL: [T, WORDS] = parametersTable (PAGE)
%
%   PAGE   see shownResult
%   T      see newTable; without a calibration the limits
%   WORDS  1 x d cell, what is known of each parameter: 'fixed'; 'dead' (it drives
%          less than 5 % of each fitted target); 'trade-off' (not fixed,
%          correlation above 0.7 with another one); 'flat direction'; 'at a limit';
%          'a compromise' (its value lies outside its interval); 'not known' (no
%          interval is printed)

function [T, words] = parametersTable (page)
  names = page.Case.names;
  c = page.sources.calibration;
  d = numel (names);
  words = cell (1, d);
  cells = cell (d, 5);
  for j = 1:d
    own = struct ('value', names{j}, 'code', names{j}, 'unit', page.params(j).unit);
    if ~isempty (page.params(j).label)
      own.value = page.params(j).label;
    end
    range = page.Case.limits(1:2, j);
    cells(j, :) = {own, NaN, NaN, range, ''};
    if ~isempty (c)
      [class, words{j}, text] = stateOf (page, names, j);
      at = @(field) {'calibration', field, names{j}};
      cells(j, 2:5) = {at('params'), at('interval90'), at('limits'), ...
                       struct('value', [words{j}, ': ', text], 'class', class)};
    end
  end
  columns = {'parameter', '', 'name'; 'value', '', 'plain'; '90 % interval', '', 'plain'; ...
             'limits', '', 'plain'; 'what is known', '', 'words'};
  title = 'Values of the parameters';
  if isempty (c)
    title = 'Limits in which the parameters are looked for';
    columns = columns([1, 4], :);
    cells = cells(:, [1, 4]);
  end
  T = newTable (page, 'parameters', title, columns, cells, notesOf (c));
end

function notes = notesOf (c)
  notes = {};
  note = char (jsonAt (c, {'intervalNote'}));
  if ~isempty (note)
    notes = {['The intervals are ', note, '.']};
  end
  for text = namesIn (c, 'unfixed')
    notes{end + 1} = sentence ('table.unfixed', struct ('names', text{1}));
  end
  next = jsonAt (c, {'next', 1});
  if ~isempty (namesIn (c, 'unfixed')) && ~isempty (next)
    notes{end + 1} = sentence ('table.fixBy', next);
  end
end

% What fixes parameter J of NAMES, or why nothing does.
function [class, word, text] = stateOf (page, names, j)
  c = page.sources.calibration;
  name = names{j};
  value = c.params.(name);
  isLoose = any (strcmp (name, namesIn (c, 'notIdentified')));
  share = sensitivityOf (c, name);
  [partner, link] = partnerOf (c, names, j);
  [class, code] = deal ('unsure', 'fixed');
  if any (strcmp (name, namesIn (c, 'atLimit')))
    [class, code] = deal ('off', 'atLimit');
  elseif strcmp (jsonAt (c, {'intervalCode'}), 'no fit')
    code = 'notKnown';
  elseif isLoose && ~isempty (share) && max (share) < 0.05
    code = 'dead';
  elseif isLoose && ~isempty (partner)
    code = 'tradeOff';
  elseif isLoose
    code = 'flat';
  elseif isOutside (value, jsonAt (c, {'interval90', name}))
    code = 'compromise';
  else
    class = 'ok';
  end
  values = struct ('partner', [partner, link], 'by', strongest (c, share), ...
                   'linked', '');
  if ~isempty (partner)
    values.linked = sentence ('known.linked', values);
  end
  [word, text] = deal (sentence (['known.', code, '.word']), ...
                       sentence (['known.', code, '.text'], values));
end

function yes = isOutside (value, range)
  yes = isnumeric (range) && numel (range) == 2 && ...
        (value < range(1) || value > range(2));
end

% Shares of the variance of the calibrated targets, NaN for the held-out ones.
function share = sensitivityOf (c, name)
  share = jsonAt (c, {'sensitivity', name})(:)';
  for t = 1:numel (share)
    if ~strcmp (jsonAt (c, {'targets', t, 'role'}), 'calibrate')
      share(t) = NaN;
    end
  end
end

function [partner, link] = partnerOf (c, names, j)
  [partner, link] = deal ('');
  R = jsonAt (c, {'correlation'});
  if isequal (size (R), numel (names) * [1, 1])
    r = R(j, :);
    r(j) = 0;
    [most, k] = max (abs (r));
    if most > 0.7
      partner = names{k};
      link = sprintf (' (correlation %.4g)', r(k));
    end
  end
end

function text = strongest (c, share)
  text = 'the targets';
  [~, order] = sort (-share);
  order = order(share(order) >= 0.1);
  if ~isempty (order)
    known = arrayfun (@(t) jsonAt (c, {'targets', t, 'name'}), ...
                      order(1:min (end, 3)), 'UniformOutput', false);
    text = strjoin (known, ', ');
  end
end

%!test
%! % each word
%! page = situationPage ('met');
%! names = {'a', 'b', 'e', 'f', 'g', 'h'};
%! page.Case.names = names;
%! page.Case.limits = repmat ([0; 10], 1, 6);
%! page.params = struct ('label', repmat ({''}, 1, 6), 'unit', 'kg');
%! page.sources.calibration = jsondecode (['{"params": {"a": 1, "b": 1, ', ...
%!   '"e": 1, "f": 9.99, "g": 1, "h": 1}, "atLimit": ["f"], ', ...
%!   '"limits": {"f": [0, 10]}, "interval90": {"a": [0, 2], "b": [0, 2], ', ...
%!   '"e": [0, 2], "f": [9, 10], "g": [0, 2], "h": [2, 3]}, ', ...
%!   '"notIdentified": ["b", "e", "g"], "targets": [{"name": "t1", ', ...
%!   '"role": "calibrate"}, {"name": "t2", "role": "holdout"}], ', ...
%!   '"sensitivity": {"a": [0.9, 0], "b": [0.01, 0.9], "e": [0.3, 0], ', ...
%!   '"f": [0.2, 0], "g": [0.2, 0], "h": [0.2, 0]}, "correlation": ', ...
%!   '[[1,0,0,0,0,0], [0,1,0,0,0,0], [0,0,1,0,-0.9,0], [0,0,0,1,0,0], ', ...
%!   '[0,0,-0.9,0,1,0], [0,0,0,0,0,1]]}']);
%! [T, words] = parametersTable (page);
%! assert (words, {'fixed', 'dead', 'trade-off', 'at a limit', 'trade-off', ...
%!                 'a compromise'});
%! known = strjoin (cellfun (@(c) c.value, T.cells(:, 5)', 'UniformOutput', false));
%! for text = {'by t1', 'only together with g', sentence('known.atLimit.text')}
%!   assert (! isempty (strfind (known, text{1})), text{1});
%! end
%! page.sources.calibration.correlation = [];
%! page.sources.calibration.intervalNote = 'not to be used';
%! [T, words] = parametersTable (page);
%! assert (T.notes{1}, 'The intervals are not to be used.');
%! assert (sum (strcmp (words, 'flat direction')), 2);
%! assert (size (parametersTable (situationPage ('nothing')).cells), [2, 2]);
