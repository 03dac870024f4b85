% CHECKPERTARGET  Checks the fields of optim that are given target by target.
%
% CALL: P = checkPerTarget (OPTIM, SIZES, TAKEN)
%
%   OPTIM  scalar struct, the optim of loadInput
%   SIZES  1 x M, targets of each model; [] where they make no sense
%   TAKEN  cell of names that a target may not have: variables
%   P      1 x n faults, see checkFault
%
% optim.tolRes (relative) is needed: {k}(i), a column of all, or one number
% for all. optim.targetStd (unit of the target), trials, targetName and role may
% be missing, also for some models; trials may also be one number for a model
% or for all.
%
% Reasons: those of the table below and <field>Count, missingField,
% duplicateTargetName, takenTargetName, noCalibrateTarget

function p = checkPerTarget (optim, sizes, taken)
  p = checkFault ();
  for rule = rulesOf ()
    if strcmp (rule.name, 'tolRes') && ~isfield (optim, 'tolRes')
      p = checkFault ('missingField', 'optim.tolRes', ...
                      'one tolerance a target', 'nothing', rule.cure);
    elseif strcmp (rule.name, 'tolRes') || ...
           (isfield (optim, rule.name) && ...
            ~checkIs ('nothing', optim.(rule.name)))
      [q, isUsable] = checkOne (optim.(rule.name), rule, sizes);
      if isUsable && strcmp (rule.name, 'targetName')
        q = [q, checkNames(optim.targetName, [taken, {'model', 'seed'}])];
      elseif isUsable && strcmp (rule.name, 'role')
        q = [q, checkSomeLeft(optim.role, sizes)];
      end
      p = [p, q];
    end
  end
end

% isGood: of one element. fits: whether g elements do for a model of n targets.
% forAll: one number may stand for all targets.
function rules = rulesOf ()
  tight = 'Write optim.tolRes{1}(1) = 0.01; and so on (0.01 is one percent).';
  isText = @(t) checkIs ('text', t);
  isName = @(t) numel (t) <= 60 && ~any (ismember (t, ',;"''\')) && ...
                ~any (t([1, end]) == ' ');
  isRole = @(t) any (strcmp (t, {'calibrate', 'holdout'}));
  upTo = @(g, n) g <= n;
  rules = {'tolRes', 'a number between 0 and 1', tight, ...
           @(v) v > 0 & v < 1, @(g, n) g == n, true; ...
           'targetStd', 'a finite number from 0', ...
           ['Set the standard uncertainty of the measured value, in its ' ...
            'unit.'], ...
           @(v) v >= 0 & isfinite (v), @(g, n) g == n | g == 0, false; ...
           'trials', 'a number above 0 or Inf', ...
           ['Write optim.trials{1}(1) = 5; where value 1 is the mean of 5 ' ...
            'trials.'], ...
           @(v) v > 0, @(g, n) g == n | g == 0 | g == 1, true; ...
           'targetName', ['a text of at most 60 characters without ' ...
                          'comma, semicolon or quotes'], ...
           'Write optim.targetName{1}{1} = ''bulk density'';', ...
           @(t) isText (t) && isName (t), upTo, false; ...
           'role', '''calibrate'' or ''holdout''', ...
           'Write optim.role{1}{2} = ''holdout'';', ...
           @(t) isText (t) && isRole (t), upTo, false};
  rules = cell2struct (rules', {'name', 'expected', 'cure', 'isGood', ...
                                'fits', 'forAll'});
  rules = rules';
end

function [p, isUsable] = checkOne (value, rule, sizes)
  field = ['optim.', rule.name];
  reason = ['bad', upper(rule.name(1)), rule.name(2:end)];
  isText = any (strcmp (rule.name, {'targetName', 'role'}));
  [values, fields, given] = checkElements (value, field);
  isUsable = ~isempty (given) && ...
             all (isText == holdsCells (value));
  if ~isUsable
    expected = {'a cell of numbers, {k}(i) for target i of model k', ...
                'a cell of cells, {k}{i} for target i of model k'};
    p = checkFault (reason, field, expected{1 + isText}, ...
                    checkShow (value), rule.cure);
    return
  end
  p = checkFault ();
  isGood = @(v) (isText && checkIs ('nothing', v)) || rule.isGood (v);
  for i = find (~cellfun (isGood, values))
    p(end + 1) = checkFault (reason, fields{i}, rule.expected, ...
                             checkShow (values{i}), rule.cure);
  end
  isUsable = isempty (p);
  if ~isempty (sizes) && ~countFits (iscell (value), given, rule, sizes)
    words = {'as many values as targets', 'at most one a target'};
    p(end + 1) = checkFault ([rule.name, 'Count'], field, ...
                             [words{1 + isText}, ': ', checkShow(sizes)], ...
                             checkShow (given), rule.cure);
  end
end

function yes = holdsCells (value)
  yes = false;
  if iscell (value)
    yes = cellfun (@iscell, value);
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

function p = checkNames (names, taken)
  p = checkFault ();
  earlier = {};
  for k = 1:numel (names)
    field = sprintf ('optim.targetName{%d}', k);
    for name = names{k}(~cellfun (@isempty, names{k}))(:)'
      if any (strcmp (name, earlier))
        p(end + 1) = checkFault ('duplicateTargetName', field, ...
                                 'names that differ', ...
                                 [checkShow(name{1}), ' twice'], ...
                                 'Rename one of the two.');
      elseif any (strcmp (name, taken))
        p(end + 1) = checkFault ('takenTargetName', field, ...
                                 'a name that no variable has', ...
                                 checkShow (name{1}), ...
                                 'Rename the target: both are columns.');
      end
      earlier = [earlier, name];
    end
  end
end

function p = checkSomeLeft (roles, sizes)
  p = checkFault ();
  nHoldout = sum (cellfun (@(r) sum (strcmp (r, 'holdout')), roles(:)'));
  if ~isempty (sizes) && nHoldout >= sum (sizes)
    p = checkFault ('noCalibrateTarget', 'optim.role', ...
                    'at least one target to calibrate on', ...
                    '''holdout'' for all', ...
                    'Set one of them to ''calibrate''.');
  end
end

%!function same (optim, reasons, sizes)
%!  if nargin < 3
%!    sizes = [2, 1];
%!  end
%!  if ! isfield (optim, 'tolRes')
%!    optim.tolRes = 0.1;
%!  end
%!  p = checkPerTarget (optim, sizes, {'densityP'});
%!  ids = arrayfun (@(q) q.id, p, 'UniformOutput', false);
%!  assert (strrep (ids(:)', 'DEcalioc:checkCase:', ''), reasons);
%!endfunction
%!test
%! none = cell (1, 0);
%! same (struct ('tolRes', {{[0.01, 0.01], 0.02}}, 'targetStd', {{[1, 2]}}, ...
%!               'trials', {{3, Inf}}), none);
%! same (struct ('trials', 5), none);
%! same (struct ('targetName', {{{'rho', 'm'}, {'slope at 15 rpm'}}}, ...
%!               'role', {{{'calibrate', 'holdout'}}}), none);
%! same (struct ('tolRes', {{[0.01, 0], 0.02}}), {'badTolRes'});
%! same (struct ('tolRes', [0.1; 0.1]), {'tolResCount'});
%! same (struct ('targetStd', -1), {'badTargetStd'}, []);
%! same (struct ('trials', {{3, [1, 2]}}), {'trialsCount'});
%! same (struct ('targetName', {{{'rho', 'rho'}, {'densityP'}}}), ...
%!       {'duplicateTargetName', 'takenTargetName'});
%! same (struct ('targetName', {{{'a'}, {'b', 'a'}}}), ...
%!       {'duplicateTargetName'}, [1, 2]);
%! same (struct ('targetName', {{'rho'}}), {'badTargetName'});
%! same (struct ('role', {{{'holdout'}}}), {'noCalibrateTarget'}, 1);
