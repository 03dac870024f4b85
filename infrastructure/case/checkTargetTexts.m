% CHECKTARGETTEXTS  Checks the names and roles of the targets.
%
% CALL: P = checkTargetTexts (OPTIM, SIZES, TAKEN)
%
%   OPTIM  scalar struct, the optim of loadInput
%   SIZES  1 x M, targets of each model; [] where they make no sense
%   TAKEN  cell of names that a target may not have: variables
%   P      1 x n faults, see checkFault
%
% Reasons: badTargetName targetNameCount duplicateTargetName takenTargetName
% badRole roleCount noCalibrateTarget
%
% See also: checkTargets

function p = checkTargetTexts (optim, sizes, taken)
  p = checkFault ();
  if isfield (optim, 'targetName') && ~checkIs ('nothing', optim.targetName)
    rule = struct ('name', 'targetName', 'reason', 'badTargetName', ...
                   'expected', ['a text of at most 60 characters without ' ...
                                'comma, semicolon or quotes'], ...
                   'cure', ...
                   'Write optim.targetName{1}{1} = ''bulk density'';', ...
                   'isGood', @isTargetName);
    [p, names] = checkOne (optim.targetName, rule, sizes);
    p = [p, checkNames(names, [taken, {'model', 'seed'}])];
  end
  if isfield (optim, 'role') && ~checkIs ('nothing', optim.role)
    rule = struct ('name', 'role', 'reason', 'badRole', ...
                   'expected', '''calibrate'' or ''holdout''', ...
                   'cure', 'Write optim.role{1}{2} = ''holdout'';', ...
                   'isGood', ...
                   @(t) any (strcmp (t, {'calibrate', 'holdout'})));
    [q, roles] = checkOne (optim.role, rule, sizes);
    p = [p, q, checkSomeLeft(roles, sizes)];
  end
end

% TEXTS is a cell of M cells of texts; {} where VALUE is not of that kind.
function [p, texts] = checkOne (value, rule, sizes)
  p = checkFault ();
  texts = {};
  field = ['optim.', rule.name];
  if ~iscell (value) || ~isvector (value) || ...
      ~all (cellfun (@(v) iscell (v) && (isvector (v) || isempty (v)), ...
                     value(:)'))
    p = checkFault (rule.reason, field, ...
                    'a cell of cells, {k}{i} for target i of model k', ...
                    checkShow (value), rule.cure);
    return
  end
  for k = 1:numel (value)
    for i = find (~cellfun (@(t) checkText (t, rule), value{k}(:)'))
      p(end + 1) = checkFault (rule.reason, ...
                               sprintf ('%s{%d}{%d}', field, k, i), ...
                               rule.expected, checkShow (value{k}{i}), ...
                               rule.cure);
    end
  end
  if isempty (p)
    texts = value;
  end
  given = cellfun (@numel, value(:)');
  if ~isempty (sizes) && (numel (given) > numel (sizes) || ...
                          any (given > sizes(1:numel (given))))
    p(end + 1) = checkFault ([rule.name, 'Count'], field, ...
                             sprintf ('at most one a target: %s', ...
                                      checkShow (sizes)), ...
                             checkShow (given), rule.cure);
  end
end

function yes = checkText (text, rule)
  yes = checkIs ('nothing', text) || ...
        (checkIs ('text', text) && rule.isGood (text));
end

function yes = isTargetName (text)
  yes = numel (text) <= 60 && ~any (ismember (text, ',;"''\')) && ...
        ~any (text([1, end]) == ' ');
end

function p = checkNames (names, taken)
  p = checkFault ();
  earlier = {};
  for k = 1:numel (names)
    here = names{k}(~cellfun (@isempty, names{k}));
    for i = 1:numel (here)
      field = sprintf ('optim.targetName{%d}', k);
      if any (strcmp (here{i}, [earlier, here(1:i - 1)(:)']))
        p(end + 1) = checkFault ('duplicateTargetName', field, ...
                                 'names that differ', ...
                                 [checkShow(here{i}), ' twice'], ...
                                 'Rename one of the two.');
      elseif any (strcmp (here{i}, taken))
        p(end + 1) = checkFault ('takenTargetName', field, ...
                                 'a name that no variable has', ...
                                 checkShow (here{i}), ...
                                 'Rename the target: both are columns.');
      end
    end
    earlier = [earlier, here(:)'];
  end
end

function p = checkSomeLeft (roles, sizes)
  p = checkFault ();
  nHoldout = sum (cellfun (@(r) sum (strcmp (r, 'holdout')), roles(:)'));
  if ~isempty (roles) && ~isempty (sizes) && nHoldout >= sum (sizes)
    p = checkFault ('noCalibrateTarget', 'optim.role', ...
                    'at least one target to calibrate on', ...
                    '''holdout'' for all', ...
                    'Set one of them to ''calibrate''.');
  end
end

%!test
%! optim = struct ('targetName', {{{'rho', 'm'}, {'slope at 15 rpm'}}}, ...
%!                 'role', {{{'calibrate', 'holdout'}}});
%! assert (isempty (checkTargetTexts (optim, [2, 1], {'densityP'})));
%!test
%! optim = struct ('targetName', {{{'rho', 'rho'}, {'densityP'}}});
%! p = checkTargetTexts (optim, [2, 1], {'densityP'});
%! assert ({p.id}, strcat ('DEcalioc:checkCase:', ...
%!         {'duplicateTargetName', 'takenTargetName'}));
%! optim.targetName = {{'slope'}, {'mass', 'slope'}};
%! assert (checkTargetTexts (optim, [1, 2], {}).id, ...
%!         'DEcalioc:checkCase:duplicateTargetName');
%!test
%! p = checkTargetTexts (struct ('role', {{{'holdout'}}}), 1, {});
%! assert (p.id, 'DEcalioc:checkCase:noCalibrateTarget');
%!test
%! p = checkTargetTexts (struct ('targetName', {{'rho'}}), 1, {});
%! assert (p.id, 'DEcalioc:checkCase:badTargetName');
