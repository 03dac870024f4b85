% DECIDECASE  What a calibration and its diagnosis mean: decided here alone.
%
% CALL: V = decideCase (C, GAP [, ISBEGUN])
%
%   C, GAP   decoded results/calibration.json, gap/gap.json; []: there is none
%   ISBEGUN  logical (false): without C, whether anything was run
%   V    scalar struct, texts without HTML:
%     word      the verdict in a few words;  class 'good', 'bad' or 'open'
%     sentence  why, one sentence
%     gap       what the diagnosis adds, one sentence; '': none was made
%     todo      struct code (of action.* in words.txt), field, names (1 x n
%               cells of texts): what action says, for programs
%     usable    logical: the calibrated set may be used;  usableFor, notFor
%               1 x n cells of texts;  action  what to do now, one sentence
%     numbers   1 x n struct label, text (with units)
%     met, of   targets that are met, all that are calibrated (a curve is one)
%     misses    see listMisses;  worst  name of the model of the largest, ''
%     cause     see decideGap; [] where no diagnosis was made
%
% Console, JSON, status and page show V; none of them decides again. A set is
% never called usable that is not converged, and a gap is never denied while
% a candidate could not be seen.

function v = decideCase (c, gap, isBegun)
  v = struct ('word', '', 'class', 'open', 'sentence', '', 'gap', '', ...
              'usable', false, 'usableFor', {{}}, 'notFor', {{}}, ...
              'action', '', 'todo', [], 'numbers', [], 'met', 0, 'of', 0, ...
              'misses', listMisses (c, gap), 'worst', '', 'cause', []);
  if nargin > 2 && isBegun
    v = withWords (v, 'case.begun');
    v = withAction (v, newAction ('goOn'));
  else
    v = withWords (v, 'case.nothing');
    v = withAction (v, newAction ('start'));
  end
  v.worst = worstTest (v.misses, gap);
  if ~isempty (c)
    v = ofCalibration (v, c);
  end
  if ~isempty (gap)
    v = withGap (v, c, decideGap (gap));
  end
  v.numbers = keyNumbers (v, c);
end

% One answer to where: that of the diagnosis, else the test of the headline.
function name = worstTest (misses, gap)
  models = jsonAt (gap, {'where', 'models'});
  name = '';
  if isfield (models, 'size') && ~isempty (models)
    [~, k] = max ([models.size]);
    name = models(k).model;
  elseif ~isempty (misses)
    name = misses(headline (misses, '')).model;
  end
end

% What is missed most over its noise, of the test NAME where it misses; a target
% that no single run can meet is none.
function k = headline (misses, name)
  isFit = ~[misses.isStrict] & ~strcmp ({misses.role}, 'unmeasured');
  isMissed = isFit & [misses.met] == 0;
  isHere = strcmp ({misses.model}, name);
  k = [find(isMissed & isHere, 1), find(isMissed, 1), find(isFit & isHere, 1), ...
       find(isFit, 1), 1];
  k = k(1);
end

function v = withWords (v, code)
  [v.word, v.sentence] = deal (sentence ([code, '.word']), ...
                               sentence ([code, '.sentence']));
end

function v = withAction (v, todo)
  [v.todo, v.action] = deal (rmfield (todo, 'text'), todo.text);
end

function numbers = keyNumbers (v, c)
  number = @(label, text) struct ('label', label, 'text', text);
  numbers = number ({}, {});
  if ~isempty (v.misses)
    numbers(end + 1) = number (missTexts (v.misses(headline (v.misses, v.worst))){:});
  end
  if v.of > 0
    label = 'targets met';
    if isequal (jsonAt (c, {'runs'}), 0)
      label = 'targets met, on the surrogates alone';
    elseif ~v.usable && v.met == v.of
      label = 'targets within tolerance so far, not surely';
    end
    isOpen = strcmp ({v.misses.state}, 'open') & [v.misses.runs] > 0;
    texts = {sprintf('%d of %d', v.met, v.of), ...
             sprintf('%d of %d, %d open', v.met, v.of, sum (isOpen))};
    numbers(end + 1) = number (label, texts{1 + any(isOpen)});
    for m = v.misses(isOpen)
      [~, text] = missTexts (m);
      numbers(end + 1) = number (['open: ', m.name], text);
    end
  end
  chance = jsonAt (c, {'probability'});
  if ~isempty (v.cause) && ~isempty (v.cause.amount)
    numbers(end + 1) = v.cause.amount;
  elseif ~isempty (chance)
    texts = {sprintf('%.0f %%', 100 * chance), '> 99 %'};
    numbers(end + 1) = number ('chance that all targets are met', ...
                               texts{1 + (chance > 0.995)});
  end
end

function v = ofCalibration (v, c)
  used = v.misses(strcmp ({v.misses.role}, 'calibrate'));
  held = v.misses(strcmp ({v.misses.role}, 'holdout'));
  v.met = sum ([used.met] == 1);
  v.of = numel (used);
  v.usable = isequal (c.converged, true);
  v.sentence = c.reason;
  if v.usable
    [v.word, v.class] = deal (sentence ('case.calibrated.word'), 'good');
    benches = strjoin (unique ({used.model}, 'stable'), ', ');
    codes = {'usableFor.like', 'usableFor.likeOpen'};
    v.usableFor{end + 1} = sentence (codes{1 + (v.met < v.of)}, ...
                                     struct ('tests', benches));
    right = {held([held.met] == 1).name};
    if ~isempty (right)
      v.usableFor{end + 1} = sentence ('usableFor.predicted', ...
                                       struct ('names', {right}));
    end
    v = withAction (v, newAction ('use'));
  else
    [v.word, v.class] = deal (sentence ('case.notCalibrated.word'), 'bad');
    v.notFor{end + 1} = notCalibrated (used, c);
    v = withAction (v, wayOn (c, used));
  end
  wrong = {held([held.met] == 0).name};
  if ~isempty (wrong)
    v.notFor{end + 1} = sentence ('notFor.wrong', ...
                                  struct ('names', {wrong}));
    if v.usable
      v.class = 'open';
      v = withAction (v, newAction ('diagnose'));
    end
  end
  v.notFor = [v.notFor, looseOnes(c), knownOnes(c)];
end

function text = notCalibrated (used, c)
  missed = {used([used.met] == 0).name};
  if ~isempty (missed)
    text = sentence ('notFor.missed', struct ('names', {missed}));
  elseif isequal (jsonAt (c, {'runs'}), 0)
    text = sentence ('notFor.noRun');
  else
    text = sentence ('notFor.unsure');
  end
end

% The one thing that can be done about parameter values that are not confirmed.
% What went wrong decides, not which budget ended; older files say the latter
% alone.
function todo = wayOn (c, used)
  limit = jsonAt (c, {'limit'});
  units = otherUnits (used([used.met] == 0));
  if ~isempty (units)
    todo = newAction ('units', units);
    return
  end
  switch givenField (jsonAt (c, {'ending'}), 'code', limit)
    case {'allFailed', 'manyFailed'}
      todo = newAction ('mendModel');
    case 'cutOff'
      todo = newAction ('moreTime', {sprintf('%g', c.ending.seconds)});
    case 'jump'
      todo = newAction ('jump', cellstr (c.ending.names)(:)', atLimit (c));
    case 'published'
      todo = newAction ('robust');
    case 'twoOutcomes'
      todo = newAction ('lookOutcomes');
    case 'conflict'
      todo = newAction ('diagnose', {}, atLimit (c));
    otherwise
      todo = raiseLimit (c, limit);
  end
end

% 'mass differ by a factor of about 1000, as between g and kg ...'
function texts = otherUnits (missed)
  texts = {};
  for m = missed
    ratio = unitRatio (m.simulated, m.measured);
    if ~isempty (ratio)
      texts{end + 1} = [m.name, ' differ by ', ratio];
    end
  end
end

function todo = raiseLimit (c, limit)
  if strcmp (limit, 'maxIter')
    todo = newAction ('diagnose', {}, atLimit (c));
  elseif isImported (c)
    todo = newAction ('runOutside');
  else
    fields = {'optim.maxFunEvals', 'Input.maxNewRuns'};
    todo = newAction ('raise', fields(1 + strcmp (limit, 'maxNewRuns')), ...
                      atLimit (c));
  end
end

function names = atLimit (c)
  names = worded (c, namesIn (c, 'atLimit'));
end

function yes = isImported (c)
  models = jsonAt (c, {'input', 'models'});
  hasKey = arrayfun (@(k) ~isempty (jsonAt (models, {k, 'key'})), ...
                     1:numel (models));
  yes = ~isempty (models) && ~any (hasKey);
end

function texts = looseOnes (c)
  loose = namesIn (c, 'notIdentified');
  if numel (loose) > 1 && numel (loose) == numel (fieldnames (c.params))
    texts = {sentence('notFor.allLoose')};
    return
  end
  loose = worded (c, loose);
  texts = {sentence('notFor.loose', ...
                    struct ('names', {loose}, ...
                            's', repmat ('s', 1, isscalar (loose))))};
  texts = texts(~isempty (loose));
end

% 'friction between grains (coefFrictionPP)', where the words are known.
function names = worded (c, names)
  for k = 1:numel (names)
    label = jsonAt (c, {'labels', names{k}});
    if ischar (label) && ~isempty (label)
      names{k} = sprintf ('%s (%s)', label, names{k});
    end
  end
end

% What was measured by itself and came out otherwise is named.
function texts = knownOnes (c)
  texts = {};
  for name = fieldnames (c.params)'
    measured = jsonAt (c, {'known', name{1}});
    value = c.params.(name{1});
    if ~isempty (measured) && abs (value - measured.mean) > 3 * measured.sd
      values = mergeFields (measured, struct ('name', worded (c, name){1}));
      values.found = value;
      texts{end + 1} = sentence ('notFor.known', values);
    end
  end
end

function v = withGap (v, c, cause)
  v.cause = cause;
  if isempty (c)
    v = mergeFields (v, cause, {'word', 'class', 'sentence'});
    v.notFor = {sentence('notFor.noCalibration')};
    v = withAction (v, orElse (cause.todo, newAction ('calibrate')));
    return
  end
  v.gap = cause.sentence;
  isAsked = strcmp (v.todo.code, 'diagnose');
  isSilent = any (strcmp (cause.kind, {'no verdict', 'cannot tell'}));
  if v.usable && ~strcmp (cause.kind, 'none')
    v.class = 'open';
    v.notFor = [v.notFor, cause.notFor];
    v = withAction (v, orElse (cause.todo, newAction ('use')));
  elseif ~v.usable && strcmp (cause.kind, 'none') && isAsked
    v = withAction (v, cause.without);
  elseif ~v.usable && ~isempty (cause.todo) && (isAsked || ~isSilent)
    v = withAction (v, cause.todo);
  end
end

function todo = orElse (todo, other)
  if isempty (todo)
    todo = other;
  end
end

%!test
%! wanted = {'met', 'Calibrated', 'good', true; ...
%!           'met, held out outside', 'Calibrated', 'open', true; ...
%!           'too few replicates', 'Not calibrated', 'bad', false; ...
%!           'met, named', 'Calibrated', 'open', true; ...
%!           'gap alone, none', 'No gap seen', 'good', false};
%! coded = @(x) jsondecode (jsonencode (x));
%! list = verdictCase ();
%! for row = wanted'
%!   s = list(strcmp ({list.name}, row{1}));
%!   v = decideCase (coded (s.c), coded (s.gap));
%!   assert ({v.word, v.class, v.usable}, row(2:4)');
%! end
