% CHECKTARGETS  Checks the fields of optim that are given target by target.
%
% CALL: [P, SIZES] = checkTargets (OPTIM, MODELS, TAKEN)
%       P = checkTargets (OPTIM, MODELS, TAKEN, SIZES)
%
%   OPTIM   scalar struct, the optim of loadInput
%   MODELS  1 x M struct array, see checkFindModels
%   TAKEN   cell of names that a target may not have: variables
%   P       1 x n faults, see checkFault
%   SIZES   1 x M, targets of each model; [] where they make no sense. Given,
%           they are those of measured.csv, which says all but optim.correlation

function [p, sizes] = checkTargets (optim, models, taken, sizes)
  rules = rulesOf (taken);
  if asksForCost (optim)
    [p, sizes] = checkCost (optim, models, rules);
    return
  elseif nargin > 3
    p = checkFault ();
    rules = rules(strcmp ({rules.name}, 'correlation'));
  else
    [p, sizes] = checkValues (optim, models);
  end
  for rule = rules
    isNeeded = strcmp (rule.name, 'tolRes');
    if isfield (optim, rule.name) && ...
       (isNeeded || ~isKind ('nothing', optim.(rule.name)))
      p = [p, checkOne(optim.(rule.name), rule, sizes)];
    elseif isNeeded
      p(end + 1) = checkFault ('missingField', 'optim.tolRes', ...
                               'one tolerance a target', 'nothing', rule.cure);
    end
  end
end

% Whatever is given instead of texts: strcmp warns of a table of characters.
function yes = asksForCost (optim)
  isCost = @(role) isequal (role, 'smallest');
  yes = false;
  roles = givenField (optim, 'role', {});
  for k = 1:numel (roles) * iscell (roles)
    yes = yes || isCost (roles{k}) || iscell (roles{k}) && ...
                                      any (cellfun (isCost, roles{k}(:)));
  end
end

% One cost, of which the smallest counts, stands alone: nothing is measured.
function [p, sizes] = checkCost (optim, models, rules)
  sizes = 1;
  p = checkFault ();
  value = givenField (optim, 'targetVal', 0);
  isAlone = isequal (optim.role, {{'smallest'}}) && isscalar (models) && ...
            any (cellfun (@(v) isequal (v, value), {0, {0}}));
  if ~isAlone
    p = checkFault ('costAlone', 'optim.role', ...
                    '''smallest'' for the one result of one model, a cost', ...
                    describeValue (optim.role), ...
                    ['Write optim.role = {{''smallest''}}; and leave ' ...
                     'optim.targetVal out, or give the results that the cost is ' ...
                     'made of.']);
  end
  if isfield (optim, 'targetName')
    rule = rules(strcmp ({rules.name}, 'targetName'));
    p = [p, checkOne(optim.targetName, rule, sizes)];
  end
end

% kind: see checkElements. isGood: of one element. fits: whether g elements do
% for a model of n targets. forAll: one number may stand for all targets. whole:
% P of all elements, once each is good.
function rules = rulesOf (taken)
  isText = @(t) isKind ('text', t);
  isName = @(t) numel (t) <= 60 && ~any (ismember (t, ',;"''\')) && ...
                ~any (t([1, end]) == ' ');
  isRole = @(t) any (strcmp (t, {'calibrate', 'holdout'}));
  orText = @(isGood) @(t) isKind ('nothing', t) || (isText (t) && isGood (t));
  none = @(values, fields, sizes) checkFault ();
  names = @(values, fields, sizes) checkNames (values, fields, ...
                                               [taken, {'model', 'seed'}]);
  upTo = @(g, n) g <= n;
  orOne = @(g, n) g == n | g <= 1;
  rules = {'tolRes', 'column', 'a number between 0 and 1', ...
           @(v) v > 0 & v < 1, @(g, n) g == n, true, none, ...
           'Write optim.tolRes{1}(1) = 0.01; and so on (one percent).'; ...
           'targetStd', 'column', 'a finite number from 0', ...
           @(v) v >= 0 & isfinite (v), @(g, n) g == n | g == 0, false, none, ...
           'Set the standard uncertainty, in the unit of the target.'; ...
           'trials', 'column', 'a number above 0 or Inf', ...
           @(v) v > 0, orOne, true, none, ...
           'Write optim.trials{1}(1) = 5; for the mean of 5 trials.'; ...
           'targetName', 'texts', ...
           'a text of at most 60 characters without comma, ; or quotes', ...
           orText(isName), upTo, false, names, ...
           'Write optim.targetName{1}{1} = ''bulk density'';'; ...
           'role', 'texts', '''calibrate'' or ''holdout''', ...
           orText(isRole), upTo, false, @checkRoles, ...
           'Write optim.role{1}{2} = ''holdout'';'; ...
           'correlation', 'cell', ...
           'a finite number from 0 (NaN: independent), or ''estimate''', ...
           @(v) isnan (v) | (v >= 0 & isfinite (v)), orOne, false, none, ...
           ['Write optim.correlation{1} = 2; (errors of model 1 are alike ' ...
            'over 2 units of at), or = ''estimate'';']};
  rules = cell2struct (rules', {'name', 'kind', 'expected', 'isGood', ...
                                'fits', 'forAll', 'whole', 'cure'})';
end

function p = checkOne (value, rule, sizes)
  field = ['optim.', rule.name];
  reason = ['bad', upper(rule.name(1)), rule.name(2:end)];
  [values, fields, given] = checkElements (value, field, rule.kind);
  isText = strcmp (rule.kind, 'texts');
  if isempty (given)
    expected = {'a cell of numbers, {k}(i) for target i of model k', ...
                'a cell of cells, {k}{i} for target i of model k'};
    p = checkFault (reason, fields{1}, expected{1 + isText}, ...
                    describeValue (values{1}), rule.cure);
    return
  end
  p = checkFault ();
  for i = find (~cellfun (rule.isGood, values))
    p(end + 1) = checkFault (reason, fields{i}, rule.expected, ...
                             describeValue (values{i}), rule.cure);
  end
  isSound = isempty (p);
  if ~isempty (sizes) && ~countFits (iscell (value), given, rule, sizes)
    words = {'as many values as targets', 'at most one a target'};
    p(end + 1) = checkFault ([rule.name, 'Count'], field, ...
                             [words{1 + isText}, ': ', describeValue(sizes)], ...
                             describeValue (given), rule.cure);
  end
  if isSound
    p = [p, rule.whole(values, fields, sizes)];
  end
end

function yes = countFits (isCell, given, rule, sizes)
  if isCell
    given(end + 1:numel (sizes)) = 0;
    yes = numel (given) == numel (sizes) && all (rule.fits (given, sizes));
  else
    yes = given == sum (sizes) || (given == 1 && rule.forAll);
  end
end

function [p, sizes] = checkValues (optim, models)
  sizes = [];
  field = 'optim.targetVal';
  expected = 'a cell of numbers, {k}(i) for result i of model k';
  cure = ['Write optim.targetVal{1}(1) = 400; and so on, or put a table measured.csv ', ...
          'into the case folder.'];
  if ~isfield (optim, 'targetVal')
    p = checkFault ('missingField', field, expected, 'nothing', cure);
    return
  end
  [values, fields, given] = checkElements (optim.targetVal, field, 'column');
  if isempty (given) || any (given == 0)
    p = checkFault ('badTargets', field, expected, ...
                    describeValue (optim.targetVal), cure);
    return
  end
  p = checkFault ();
  for i = find (~isfinite ([values{:}]))
    p(end + 1) = checkFault ('nonFiniteTarget', fields{i}, ...
                             'a finite number', describeValue (values{i}), ...
                             'Set the measured value.');
  end
  for i = find ([values{:}] == 0)
    p(end + 1) = checkFault ('zeroTarget', fields{i}, ...
                             'a number that is not 0', '0', ...
                             ['Give it in measured.csv with an absolute ' ...
                              'tolerance, or let getResults return a ' ...
                              'shifted value.']);
  end
  if ~isempty (models)
    isOfModel = iscell (optim.targetVal) || isscalar (models);
    [q, sizes] = checkCount (isOfModel, given, models);
    p = [p, q];
  end
end

function [p, sizes] = checkCount (isOfModel, given, models)
  p = checkFault ();
  counts = [models.count];
  sizes = [];
  texts = arrayfun (@(m) sprintf (['%d value(s), as many as getResults of ' ...
                                   '%s returns'], m.count, m.name), ...
                    models, 'UniformOutput', false);
  field = 'optim.targetVal';
  cure = ['Give one target for each result, in the order of getResults.', ...
          ofToolbox(models)];
  if isOfModel && numel (given) == numel (models)
    sizes = given;
    for k = find (~isnan (counts) & counts ~= given)
      p(end + 1) = checkFault ('targetCount', sprintf ('%s{%d}', field, k), ...
                               texts{k}, sprintf ('%d', given(k)), cure);
    end
  elseif isOfModel
    p = checkFault ('targetCount', field, ...
                    sprintf ('%d cell(s), one a model', numel (models)), ...
                    sprintf ('%d', numel (given)), ...
                    'Write optim.targetVal{k}(i) for every model k.');
  elseif any (isnan (counts))
    p = checkFault ('ambiguousTargets', field, ...
                    'a cell with the targets of each model', ...
                    ['one column, and getResults of ', ...
                     models(find (isnan (counts), 1)).name, ...
                     ' does not tell how many are its own'], ...
                    ['Take the line optim.targetVal = horzcat (...) out ' ...
                     'of loadInput.m.']);
  elseif given ~= sum (counts)
    p = checkFault ('targetCount', field, ...
                    strjoin (texts, ' and '), sprintf ('%d', given), cure);
  else
    sizes = counts;
  end
end

function p = checkNames (names, fields, taken)
  p = checkFault ();
  for i = find (~cellfun (@isempty, names))
    if any (strcmp (names{i}, names(1:i - 1)))
      p(end + 1) = checkFault ('duplicateTargetName', fields{i}, ...
                               'names that differ', ...
                               [describeValue(names{i}), ' twice'], ...
                               'Rename one of the two.');
    elseif any (strcmp (names{i}, taken))
      p(end + 1) = checkFault ('takenTargetName', fields{i}, ...
                               'a name that no variable has', ...
                               describeValue (names{i}), ...
                               'Rename the target: both are columns.');
    end
  end
end

function p = checkRoles (roles, ~, sizes)
  p = checkFault ();
  if ~isempty (sizes) && sum (strcmp (roles, 'holdout')) >= sum (sizes)
    p = checkFault ('noCalibrateTarget', 'optim.role', ...
                    'at least one target to calibrate on', ...
                    '''holdout'' for all', ...
                    'Set one of them to ''calibrate''.');
  end
end

%!test
%! % targets of each model: as given, or counted by getResults
%! models = struct ('name', {'A', 'B'}, 'count', {2, 1}, 'folder', '');
%! for value = {{[1, 2], 3}, [1; 2; 3]}
%!   optim = struct ('targetVal', value, 'tolRes', 0.1);
%!   [p, sizes] = checkTargets (optim, models, {});
%!   assert ({isempty(p), sizes}, {true, [2, 1]});
%! end
%! p = checkTargets (optim, struct ('name', 'A', 'count', 2, 'folder', ''), {});
%! assert (p.id, 'DEcalioc:checkCase:targetCount');
%!test
%! % a table of characters is a fault, and no warning of Octave's
%! lastwarn ('');
%! optim = struct ('targetVal', {{1}}, 'tolRes', 0.1, 'role', {{{['ab'; 'cd']}}});
%! p = checkTargets (optim, struct ('name', 'A', 'count', 1, 'folder', ''), {});
%! assert (strncmp (p.message, 'optim.role', 10), p.message);
%! assert (lastwarn (), '');

% SPDX-License-Identifier: GPL-3.0-only
