% DECIDECASE  What a calibration and its diagnosis mean: decided here alone.
%
% CALL: V = decideCase (C, GAP [, ISBEGUN])
%
%   C, GAP   decoded results/calibration.json, gap/gap.json; []: there is none
%   ISBEGUN  logical (false): without C, whether anything was run
%   V    scalar struct, texts without HTML:
%     word      the verdict in a few words;  class 'good', 'bad' or 'open'
%     sentence  why, one sentence
%     change    what has changed since the reference, see firstLine; '': nothing is
%               compared with one
%     gap       what the diagnosis adds, one sentence; '': none was made
%     todo      struct code (of action.* in words.txt), field, names (1 x n
%               cells of texts): what action says, for programs
%     usable    logical: the calibrated set may be used;  usableFor, notFor
%               1 x n cells of texts;  action  what to do now, one sentence
%     actionParts  its parts, see sentence: which of them are commands or files
%     numbers   1 x n struct label, text (with units)
%     met, of   targets that are met, all that are calibrated (a curve is one)
%     misses    see listMisses;  worst  name of the model of the largest, ''
%     cause     see decideGap; [] where no diagnosis was made
%
% Console, JSON, status and page show V; none of them decides again. A set is
% never called usable that is not converged, and a gap is never denied while
% a candidate could not be seen.

function v = decideCase (c, gap, isBegun)
  v = struct ('word', '', 'class', 'open', 'sentence', '', 'change', '', 'gap', '', ...
              'usable', false, 'usableFor', {{}}, 'notFor', {{}}, ...
              'action', '', 'actionParts', [], 'todo', [], 'numbers', [], 'met', 0, 'of', 0, ...
              'misses', listMisses (c, gap), 'worst', '', 'cause', []);
  isBegun = nargin > 2 && isBegun;
  [code, todo] = deal ('case.nothing', 'start');
  if isBegun
    [code, todo] = deal ('case.begun', 'goOn');
  end
  v.word = sentence ([code, '.word']);
  v.sentence = sentence ([code, '.sentence']);
  v = withAction (v, newAction (todo));
  v.worst = worstTest (v.misses, gap);
  if ~isempty (c)
    v = ofCalibration (v, c);
  end
  if ~isempty (gap)
    before = v;
    v = withGap (v, c, decideGap (gap));
    if strcmp (before.todo.code, 'units')           % no cause before that
      v = mergeFields (v, before, {'todo', 'action', 'actionParts'});
    end
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

% Label and text of each.
function numbers = keyNumbers (v, c)
  list = valueTexts (v, c);
  if ~isempty (v.misses) && (isempty (v.change) || ~isempty (c))
    % of a change alone it is said first, see firstLine
    list = [list; largestMiss(v)];
  end
  if v.of > 0
    list = [list; metTargets(v, c)];
  end
  if ~isempty (jsonAt (c, {'sources'}))
    list(end + 1, :) = {'runs that count', sourcesText(c.sources)};
  end
  none = jsonNumber (c, {'outcomes', 'none'}, 0);
  if none > 0
    tried = none + jsonNumber (c, {'outcomes', 'resulting'}, 0);
    list(end + 1, :) = {'runs with these values that gave no result', ...
                        sprintf('%d of %d', none, tried)};
  end
  chance = jsonAt (c, {'probability'});
  if ~isempty (v.cause) && ~isempty (v.cause.amount)
    list = [list; {v.cause.amount.label, v.cause.amount.text}];
  elseif ~isempty (chance)
    text = sprintf ('%.0f %%', 100 * chance);
    if chance > 0.995
      text = '> 99 %';
    elseif chance < 0.005
      text = '< 1 %';
    end
    list = [list; {sentence(['chance.', chanceCode(v.misses)]), text}];
  end
  numbers = struct ('label', list(:, 1)', 'text', list(:, 2)');
end

function texts = largestMiss (v)
  texts = missTexts (v.misses(headline (v.misses, v.worst)));
  if ~isempty (jsonAt (v, {'cause', 'change'}))
    texts{1} = ['at the reference, ', texts{1}];
  end
end

% What was looked for, where it was found and nothing else is said first.
function list = valueTexts (v, c)
  list = cell (0, 2);
  if isempty (c) || ~v.usable || ~isempty (v.change) || ~isempty (v.cause)
    return
  end
  for name = fieldnames (c.params)'
    text = sprintf ('%.3g', c.params.(name{1}));
    interval = jsonAt (c, {'interval90', name{1}});
    if numel (interval) == 2 && all (isfinite (interval))
      text = sprintf ('%s (%.3g to %.3g)', text, interval);
    end
    list(end + 1, :) = {worded(c, name){1}, text};
  end
end

% How many targets are met, and which are open.
function list = metTargets (v, c)
  open = v.misses(isOpenMiss (v.misses));
  label = 'targets met';
  if c.runs == 0
    label = 'targets met, expected from the fit, not yet run';
  elseif ~v.usable && v.met == v.of
    label = 'targets within tolerance so far, not surely';
  end
  text = sprintf ('%d of %d', v.met, v.of);
  if ~isempty (open)
    text = sprintf ('%s, %d open', text, numel (open));
  end
  says = eachOf (@(m) {['open: ', m.name]; nthargout(2, @missTexts, m)}, open);
  list = [{label, text}; [says{:}]'];
end

function code = chanceCode (misses)
  code = 'all';
  if any (strcmp ({misses.state}, 'unjudged') & strcmp ({misses.role}, 'calibrate'))
    code = 'judged';
  end
end

% '14 of this case, 60 imported'.
function text = sourcesText (from)
  counts = [from.own, from.imported, from.otherCases];
  words = {'of this case', 'imported', 'of other cases'};
  parts = arrayfun (@(n, word) sprintf ('%d %s', n, word{1}), counts, words, ...
                    'UniformOutput', false);
  text = strjoin (parts([true, counts(2:3) > 0]), ', ');
end

function v = ofCalibration (v, c)
  used = v.misses(strcmp ({v.misses.role}, 'calibrate'));
  held = v.misses(strcmp ({v.misses.role}, 'holdout'));
  v.met = sum ([used.met] == 1);
  v.of = numel (used);
  v.usable = isequal (c.converged, true);
  v.sentence = strtrim ([char(jsonAt (c, {'sources', 'misled'})), ' ', c.reason]);
  right = {held([held.met] == 1).name};
  wrong = {held([held.met] == 0).name};
  isOut = strcmp ({v.misses.state}, 'unjudged');
  open = {held(isnan ([held.met]) & ~strcmp ({held.state}, 'unjudged')).name};
  if v.usable
    [v.word, v.class] = deal (sentence ('case.calibrated.word'), 'good');
    v.usableFor = listSentences ({'usableFor.like', unique({used.model}, 'stable'); ...
                                  'usableFor.predicted', right});
    v = withAction (v, newAction ('use'));
  else
    [v.word, v.class] = deal (sentence ('case.notCalibrated.word'), 'bad');
    v.notFor = {notCalibrated(used, c)};
    v = withAction (v, wayOn (c, used));
  end
  if v.usable && ~isempty (wrong)
    v.class = 'open';
    v = withAction (v, newAction ('diagnose'));
  end
  v.notFor = [v.notFor, ...
              listSentences({'notFor.wrong', wrong; 'notFor.leftOpen', open; ...
                             'notFor.unjudged', {v.misses(isOut).name}; ...
                             'notFor.neverVaried', namesIn(c, 'neverVaried')}), ...
              looseOnes(c), knownOnes(c)];
end

function text = notCalibrated (used, c)
  missed = {used([used.met] == 0).name};
  code = 'notFor.unsure';
  if ~isempty (missed)
    code = 'notFor.missed';
  elseif c.runs == 0
    code = 'notFor.noRun';
  end
  text = sentence (code, missed);
end

% The one thing that can be done about parameter values that are not confirmed.
% What went wrong decides, not which budget ended.
function todo = wayOn (c, used)
  units = otherUnits (used([used.met] == 0));
  [limit, code] = deal (c.limit, c.ending.code);
  plain = struct ('allFailed', 'mendModel', 'manyFailed', 'mendModel', ...
                  'published', 'robust', 'twoOutcomes', 'lookOutcomes', ...
                  'noResult', 'lookNone');
  if strcmp (code, 'twoOutcomes') && c.ending.other == 0
    plain = rmfield (plain, code);       % earlier runs did, own ones not yet
  end
  widen = worded (c, drivingOf (c, namesIn (c, 'atLimit')));
  if ~isempty (units)
    todo = newAction ('units', units);
  elseif strcmp (code, 'unjudged')
    todo = newAction ('returnZero', cellstr (c.ending.names)(:)');
  elseif isfield (plain, code)
    todo = newAction (plain.(code));
  elseif strcmp (code, 'cutOff')
    todo = newAction ('moreTime', {sprintf('%g', c.ending.seconds)});
  elseif strcmp (code, 'jump')
    todo = newAction ('jump', cellstr (c.ending.names)(:)', widen);
  elseif isMissedForGood (code, limit, used)
    todo = newAction ('diagnose', {}, widen);
  elseif isImported (c)
    todo = newAction ('runOutside');
  else
    todo = goFurther (limit, used, widen);
  end
  if isempty (units)
    todo.parts = [todo.parts, sayFirst(halfOrTwice (used([used.met] == 0)), [])];
  end
end

% Beyond the limits where no run came to what was measured, else more runs within.
function todo = goFurther (limit, used, widen)
  if ~isempty (widen) && any (arrayfun (@isBeyond, used([used.met] == 0)))
    todo = newAction ('widenLimits', widen);
  else
    field = merge (strcmp (limit, 'maxNewRuns'), 'Input.maxNewRuns', 'optim.maxFunEvals');
    todo = newAction ('raise', {field}, widen);
  end
end

% Without those that drive less than 5 % of the variance of each calibrated target.
function names = drivingOf (c, names)
  share = @(t, name) jsonNumber (c, {'targets', t, 'sensitivity', name}, 1);
  isFit = @(t) strcmp (jsonAt (c, {'targets', t, 'role'}), 'calibrate');
  fit = find (arrayfun (isFit, 1:numel (jsonList (c, {'targets'}))));
  drives = @(name) any (arrayfun (@(t) share (t, name), fit) >= 0.05);
  names = names(cellfun (drives, names));
end

% Where all targets are met and it is not sure, more runs make it so.
function yes = isMissedForGood (code, limit, used)
  yes = any (strcmp (code, {'conflict', 'beyondScatter'})) || ...
        (any (strcmp (limit, {'maxIter', 'unsettled'})) && any ([used.met] == 0));
end

% 'mass differ by a factor of about 1000, as between g and kg ...': from the expectation, or
% from all runs.
function texts = otherUnits (missed)
  texts = cell (1, 0);
  for m = missed
    from = m.simulated;
    if isBeyond (m)
      from = [from, m.range];
    end
    ratios = arrayfun (@(z) unitRatio (z, m.measured), from, 'UniformOutput', false);
    ratios = ratios(~cellfun (@isempty, ratios));
    if ~isempty (ratios)
      texts{end + 1} = [m.name, ' differ by ', ratios{1}];
    end
  end
end

% A slip that only a single miss, which no run comes near, may be.
function text = halfOrTwice (missed)
  text = '';
  if ~isscalar (missed)
    return
  end
  shares = struct ('half', 0.5, 'twice', 2);
  for name = fieldnames (shares)'
    own = missed.measured * shares.(name{1});
    isFar = all (abs (log (missed.range / missed.measured)) > log (1.4));
    if isFar && own > missed.range(1) && own < missed.range(2)
      text = [' ', sentence('hint.half', struct ('name', missed.name, 'share', name{1}))];
    end
  end
end

function yes = isBeyond (m)
  yes = m.measured < m.range(1) || m.measured > m.range(2);
end

function yes = isImported (c)
  models = jsonList (c, {'input', 'models'});
  yes = ~isempty (models) && all (cellfun (@(m) isempty (jsonAt (m, {'key'})), models));
end

function texts = looseOnes (c)
  loose = namesIn (c, 'notIdentified');
  texts = {sentence('notFor.allLoose')};
  if numel (loose) < 2 || numel (loose) < numel (fieldnames (c.params))
    texts = listSentences ({'notFor.loose', worded(c, loose)});
  end
end

% 'friction between grains (coefFrictionPP)', where the words are known.
function names = worded (c, names)
  for k = 1:numel (names)
    label = char (jsonAt (c, {'labels', names{k}}));
    if ~isempty (label)
      names{k} = sprintf ('%s (%s)', label, names{k});
    end
  end
end

% What was measured by itself and came out otherwise is named.
function texts = knownOnes (c)
  texts = {};
  for name = fieldnames (c.params)'
    known = jsonAt (c, {'known', name{1}});
    value = c.params.(name{1});
    if ~isempty (known) && abs (value - known.mean) > 3 * known.sd
      [known.name, known.found] = deal (worded (c, name){1}, value);
      texts{end + 1} = sentence ('notFor.known', known);
    end
  end
end

% Of several conditions by its name.
function text = toldChange (cause)
  text = cause.change;
  if ~isempty (cause.condition) && ~isempty (text)
    text = [cause.condition, ': ', text];
  end
end

function v = withGap (v, c, cause)
  [v.cause, v.change] = deal (cause, toldChange (cause));
  if isempty (c)
    v = mergeFields (v, cause, {'word', 'class', 'sentence'});
    [v.notFor, todo] = deal ({sentence('notFor.noCalibration')}, newAction ('calibrate'));
    if ~isempty (v.change)             % no calibration is needed for that
      [v.notFor, todo] = deal ({}, newAction ('smallerChange'));
    end
    v = withAction (v, orElse (cause.todo, todo));
    return
  end
  v.gap = cause.sentence;
  isAsked = strcmp (v.todo.code, 'diagnose');
  isNone = strcmp (cause.kind, 'none');
  isSilent = any (strcmp (cause.kind, {'no verdict', 'cannot tell'}));
  if v.usable && ~isNone
    v.class = 'open';
    v.notFor = [v.notFor, cause.notFor];
    v = withAction (v, orElse (cause.todo, newAction ('use')));
  elseif ~v.usable && isNone && isAsked
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
%! % what was looked for comes first
%! s = list(strcmp ({list.name}, 'met'));
%! [s.c.params, s.c.interval90] = deal (struct ('mu', 0.30779), struct ('mu', [0.2255, 0.5778]));
%! s.c.labels.mu = 'friction';
%! v = decideCase (coded (s.c), []);
%! assert ({v.numbers(1).label, v.numbers(1).text}, ...
%!         {'friction (mu)', '0.308 (0.226 to 0.578)'});
%!test
%! % all met, and not sure: more runs, no cause
%! list = verdictCase ();
%! s = list(strcmp ({list.name}, 'met'));
%! s.c.converged = false;
%! s.c.limit = 'maxIter';
%! coded = @(x) jsondecode (jsonencode (x));
%! for row = {'unsure', 0, 'raise'; 'twoOutcomes', 0, 'raise'; 'twoOutcomes', 1, 'lookOutcomes'; ...
%!            'conflict', 0, 'diagnose'}'
%!   [s.c.ending.code, s.c.ending.other] = deal (row{1:2});
%!   v = decideCase (coded (s.c), []);
%!   assert (v.todo.code, row{3});
%!   assert (! strcmp (row{3}, 'raise') || strcmp (v.todo.field, 'optim.maxFunEvals'));
%! end
%! % beyond what all runs gave, and a parameter that drives it at its limit
%! [s.c.ending.code, s.c.limit, s.c.atLimit] = deal ('outside', 'maxFunEvals', {'mu'});
%! s.c.targets(1).role = 'calibrate';
%! [s.c.targets(1).met, s.c.targets(1).target] = deal (false, 14);
%! s.c.targets(1).range = [15, 30];
%! assert (decideCase (coded (s.c), []).todo.code, 'widenLimits');
%! s.c.targets(1).range = [13, 30];
%! assert (decideCase (coded (s.c), []).todo.code, 'raise');
%! for t = 1:numel (s.c.targets)
%!   s.c.targets(t).sensitivity = struct ('mu', 0.02);
%! end
%! s.c.targets(1).range = [15, 30];
%! assert (decideCase (coded (s.c), []).todo.widen, {});
%!test
%! % one result in another unit, by all runs: no cause before that; half of what was measured
%! list = verdictCase ();
%! s = list(strcmp ({list.name}, 'missed, named'));
%! coded = @(x) jsondecode (jsonencode (x));
%! said = @(c) decideCase (coded (c), coded (s.gap));
%! alone = @(c) decideCase (coded (c), []).action;
%! assert (! strcmp (said (s.c).todo.code, 'units'));
%! [s.c.targets(1).target, s.c.targets(1).range] = deal (25000, [7, 30]);
%! v = said (s.c);
%! assert (v.todo.code, 'units');
%! assert (! isempty (strfind (v.action, 'sum differ by a factor of about 1000, as betw')));
%! s.c.targets(1).range = [7, 30000];
%! assert (! strcmp (said (s.c).todo.code, 'units'));
%! [s.c.targets(1).target, s.c.targets(1).range] = deal (17, [7, 12]);
%! assert (! isempty (strfind (alone (s.c), 'measured sum, half of it would lie')));
%! s.c.targets(1).range = [9, 12];
%! assert (isempty (strfind (alone (s.c), 'half of it')));

% SPDX-License-Identifier: GPL-3.0-only
