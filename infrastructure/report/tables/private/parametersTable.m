% PARAMETERSTABLE  Statement: the values of the parameters, and how well they are
% known.
%
% CALL: [T, WORDS] = parametersTable (PAGE)
%
%   PAGE   see shownResult
%   T      see newTable; without a calibration the limits
%   WORDS  1 x d cell, what is known of each parameter: 'fixed' (to less than a quarter
%          of its limits, and in no combination that is left open); 'narrowed down' (to
%          less than half); 'dead' (it drives less than 5 % of each fitted target);
%          'trade-off' (not fixed, correlation above 0.7 with another one); 'not
%          determined'; 'at a limit';
%          'a compromise' (its value lies outside its interval); 'not known' (no
%          interval is printed)

function [T, words] = parametersTable (page)
  names = page.Case.names;
  c = page.sources.calibration;
  if isempty (c)
    row = @(j) {nameOf(page, j), page.Case.limits(1:2, j)};
    T = newTable (page, 'parameters', 'Limits in which the parameters are looked for', ...
                  {'parameter', '', 'name'; 'limits', '', 'plain'}, ...
                  eachOf (row, 1:numel (names)));
    return
  end
  states = eachOf (@(j) stateOf (c, names, j), 1:numel (names));
  words = cellfun (@(s) s.word, states, 'UniformOutput', false);
  at = @(field, j) {'calibration', field, names{j}};
  row = @(j) {nameOf(page, j), at('params', j), at('interval90', j), at('limits', j), ...
              struct('value', [words{j}, ': ', states{j}.text], 'class', states{j}.class)};
  T = newTable (page, 'parameters', 'Values of the parameters', ...
                {'parameter', '', 'name'; 'value', '', 'plain'; ...
                 '90 % interval', '', 'plain'; 'limits', '', 'plain'; ...
                 'what is known', '', 'words'}, eachOf (row, 1:numel (names)), notesOf (c));
end

function entry = nameOf (page, j)
  name = page.Case.names{j};
  entry = struct ('value', givenField (page.params(j), 'label', name), 'code', name, ...
                  'unit', page.params(j).unit);
end

function notes = notesOf (c)
  notes = {};
  if ~isempty (jsonAt (c, {'intervalCode'}))
    notes = {['The intervals are ', c.intervalNote, '.']};
  end
  notes = [notes, strcat(namesIn (c, 'neverVaried'), '.')];
  loose = namesIn (c, 'unfixed');
  next = jsonAt (c, {'next', 1});
  if numel (loose) == numel (fieldnames (c.params))
    notes{end + 1} = sentence ('table.allOpen');
  else
    notes = [notes, eachOf(@(text) sentence ('table.unfixed', {text}), loose)];
  end
  if ~isempty (loose) && ~isempty (next)
    notes{end + 1} = sentence (['fixBy.', next.code], next);
  end
end

% What fixes parameter J of NAMES, or why nothing does.
function s = stateOf (c, names, j)
  name = names{j};
  isLoose = any (strcmp (name, namesIn (c, 'notIdentified')));
  share = sensitivityOf (c, name);
  partner = partnerOf (c, names, j);
  range = [jsonAt(c, {'interval90', name})(:)', -Inf, Inf];
  class = 'unsure';
  isAtLimit = any (strcmp (name, namesIn (c, 'atLimit')));
  if (isLoose || isAtLimit) && any (max (share) < 0.05)
    code = 'dead';
  elseif isAtLimit
    [class, code] = deal ('off', 'atLimit');
  elseif strcmp (jsonAt (c, {'intervalCode'}), 'no fit')
    code = 'notKnown';
  elseif isLoose
    codes = {'flat', 'tradeOff'};
    code = codes{2 - isempty(partner)};
  elseif c.params.(name) < range(1) || c.params.(name) > range(2)
    code = 'compromise';
  elseif isOpen (c, name) || widthOf (c, name) > 0.25
    code = 'narrowed';
  else
    [class, code] = deal ('ok', 'fixed');
  end
  values = struct ('partner', partner, 'by', strongest (c, share), 'linked', '', ...
                   'share', round (100 * widthOf (c, name)), ...
                   'from', plainNumber (range(1), 'plain'), ...
                   'to', plainNumber (range(2), 'plain'));
  if ~isempty (partner)
    values.linked = sentence ('known.linked', values);
  end
  s = struct ('class', class, 'word', sentence (['known.', code, '.word']), ...
              'text', sentence (['known.', code, '.text'], values));
end

% Named in a combination that the tests leave open.
function yes = isOpen (c, name)
  pattern = ['(?<!\w)', regexptranslate('escape', name), '(?!\w)'];
  yes = any (cellfun (@(text) ~isempty (regexp (text, pattern, 'once')), ...
                      namesIn (c, 'unfixed')));
end

% Of its interval, in shares of its limits.
function w = widthOf (c, name)
  sizes = cellfun (@(field) max ([diff(jsonAt (c, {field, name})(:)'), NaN]), ...
                   {'interval90', 'limits'});
  w = sizes(1) / sizes(2);
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

function text = partnerOf (c, names, j)
  text = '';
  R = jsonAt (c, {'correlation'});
  if isequal (size (R), numel (names) * [1, 1])
    R(j, j) = 0;
    [most, k] = max (abs (R(j, :)));
    if most > 0.7
      text = sprintf ('%s (correlation %.4g)', names{k}, R(j, k));
    end
  end
end

function text = strongest (c, share)
  [~, order] = sort (-share);
  order = order(share(order) >= 0.1);
  known = eachOf (@(t) jsonAt (c, {'targets', t, 'name'}), order(1:min (end, 3)));
  text = strjoin ([known, repmat({'the targets'}, 1, isempty (known))], ', ');
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
%! page.sources.calibration.intervalCode = 'unseen';
%! page.sources.calibration.intervalNote = 'not to be used';
%! page.sources.calibration.unfixed = 'more a with less b';
%! page.sources.calibration.next = struct ('code', 'direct', 'kind', '', 'name', 'b');
%! [T, words] = parametersTable (page);
%! assert (T.notes, {'The intervals are not to be used.', ...
%!                   sentence('table.unfixed', {'more a with less b'}), ...
%!                   sentence('fixBy.direct', struct ('name', 'b'))});
%! assert (sum (strcmp (words, 'not determined')), 2);
%! assert (size (parametersTable (situationPage ('nothing')).cells), [2, 2]);

% SPDX-License-Identifier: GPL-3.0-only
