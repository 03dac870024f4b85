% CHECKTARGETNUMBERS  Checks tolerances, uncertainties, trials of the targets.
%
% CALL: P = checkTargetNumbers (OPTIM, SIZES)
%
%   OPTIM  scalar struct, the optim of loadInput
%   SIZES  1 x M, targets of each model; [] where they make no sense
%   P      1 x n faults, see checkFault
%
% optim.tolRes (relative) is needed: {k}(i), a column of all, or one number
% for all. optim.targetStd (unit of the target) may be missing, also for some
% models; so may optim.trials, which may also be one number for a model or for
% all.
%
% Reasons: missingField badTolRes tolResCount badTargetStd targetStdCount
% badTrials trialsCount
%
% See also: checkTargets, perTarget

function p = checkTargetNumbers (optim, sizes)
  cure = 'Write optim.tolRes{1}(1) = 0.01; and so on (0.01 is one percent).';
  if ~isfield (optim, 'tolRes')
    p = checkFault ('missingField', 'optim.tolRes', ...
                    'one tolerance a target', 'nothing', cure);
  else
    rule = struct ('name', 'tolRes', 'reason', 'badTolRes', ...
                   'expected', 'a number between 0 and 1', 'cure', cure, ...
                   'isGood', @(v) v > 0 & v < 1, 'optional', false, ...
                   'forAll', true, 'forModel', false);
    p = checkOne (optim.tolRes, rule, sizes);
  end
  rules = struct ('name', {'targetStd', 'trials'}, ...
                  'reason', {'badTargetStd', 'badTrials'}, ...
                  'expected', {'a finite number from 0', ...
                               'a number above 0 or Inf'}, ...
                  'cure', {['Set the standard uncertainty of the ' ...
                            'measured value, in its unit.'], ...
                           ['Write optim.trials{1}(1) = 5; where value 1 ' ...
                            'is the mean of 5 trials.']}, ...
                  'isGood', {@(v) v >= 0 & isfinite (v), @(v) v > 0}, ...
                  'optional', true, 'forAll', {false, true}, ...
                  'forModel', {false, true});
  for rule = rules
    if isfield (optim, rule.name) && ...
        ~checkIs ('nothing', optim.(rule.name))
      p = [p, checkOne(optim.(rule.name), rule, sizes)];
    end
  end
end

function p = checkOne (value, rule, sizes)
  field = ['optim.', rule.name];
  [values, fields, given] = checkElements (value, field);
  if isempty (given)
    p = checkFault (rule.reason, field, ...
                    'a cell of numbers, {k}(i) for target i of model k', ...
                    checkShow (value), rule.cure);
    return
  end
  p = checkFault ();
  for i = find (~rule.isGood (values))
    p(end + 1) = checkFault (rule.reason, fields{i}, rule.expected, ...
                             checkShow (values(i)), rule.cure);
  end
  if ~isempty (sizes)
    p = [p, checkCount(iscell (value), given, rule, sizes)];
  end
end

function p = checkCount (isCell, given, rule, sizes)
  p = checkFault ();
  if isCell && rule.optional
    given(end + 1:numel (sizes)) = 0;
    sizes(given(1:numel (sizes)) == 0) = 0;
  end
  if isCell && rule.forModel && numel (given) == numel (sizes)
    given(given == 1) = sizes(given == 1);
  end
  if isCell
    fits = isequal (given, sizes);
  else
    fits = given == sum (sizes) || (given == 1 && rule.forAll);
  end
  if ~fits
    p = checkFault ([rule.name, 'Count'], ['optim.', rule.name], ...
                    sprintf ('as many values as targets: %s', ...
                             checkShow (sizes)), ...
                    checkShow (given), rule.cure);
  end
end

%!test
%! optim = struct ('tolRes', {{[0.01, 0.01], 0.02}}, 'targetStd', {{[1, 2]}});
%! assert (isempty (checkTargetNumbers (optim, [2, 1])));
%!assert (isempty (checkTargetNumbers (struct ('tolRes', 0.01), [2, 1])))
%!test
%! p = checkTargetNumbers (struct ('tolRes', {{[0.01, 0], 0.02}}), [2, 1]);
%! assert (p.id, 'DEcalioc:checkCase:badTolRes');
%! assert (strncmp (p.message, 'optim.tolRes{1}(2)', 18));
%!test
%! p = checkTargetNumbers (struct ('tolRes', [0.1; 0.1]), [2, 1]);
%! assert (p.id, 'DEcalioc:checkCase:tolResCount');
%!test
%! p = checkTargetNumbers (struct ('tolRes', 0.1, 'targetStd', -1), []);
%! assert (p.id, 'DEcalioc:checkCase:badTargetStd');
%!assert (isempty (checkTargetNumbers (struct ('tolRes', 0.1, 'trials', ...
%!                                             {{3, [1, Inf]}}), [2, 2])))
%!assert (isempty (checkTargetNumbers (struct ('tolRes', 0.1, 'trials', 5), ...
%!                                     [2, 2])))
%!assert (checkTargetNumbers (struct ('tolRes', 0.1, 'trials', ...
%!                                    {{3, [1, NaN]}}), [2, 2]).id, ...
%!        'DEcalioc:checkCase:badTrials')
%!assert (checkTargetNumbers (struct ('tolRes', 0.1, 'trials', ...
%!                                    {{3, [1, 2, 3]}}), [2, 2]).id, ...
%!        'DEcalioc:checkCase:trialsCount')
