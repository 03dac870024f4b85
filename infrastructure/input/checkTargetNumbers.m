% CHECKTARGETNUMBERS  Checks the tolerances and uncertainties of the targets.
%
% CALL: P = checkTargetNumbers (OPTIM, SIZES)
%
%   OPTIM  scalar struct, the optim of loadInput
%   SIZES  1 x M, targets of each model; [] where they make no sense
%   P      1 x n problems, see checkProblem
%
% optim.tolRes (relative) is needed: {k}(i), a column of all, or one number
% for all. optim.targetStd (unit of the target) may be missing, also for some
% models.
%
% Reasons: missingField badTolRes tolResCount badTargetStd targetStdCount
%
% See also: checkTargets

function p = checkTargetNumbers (optim, sizes)
  cure = 'Write optim.tolRes{1}(1) = 0.01; and so on (0.01 is one percent).';
  if ~isfield (optim, 'tolRes')
    p = checkProblem ('missingField', 'optim.tolRes', ...
                      'one tolerance a target', 'nothing', cure);
  else
    rule = struct ('name', 'tolRes', 'reason', 'badTolRes', ...
                   'expected', 'a number between 0 and 1', 'cure', cure, ...
                   'isGood', @(v) v > 0 & v < 1, 'optional', false);
    p = checkOne (optim.tolRes, rule, sizes);
  end
  if isfield (optim, 'targetStd') && ~checkIs ('nothing', optim.targetStd)
    rule = struct ('name', 'targetStd', 'reason', 'badTargetStd', ...
                   'expected', 'a finite number from 0', ...
                   'cure', ['Set the standard uncertainty of the measured ' ...
                            'value, in its unit.'], ...
                   'isGood', @(v) v >= 0 & isfinite (v), 'optional', true);
    p = [p, checkOne(optim.targetStd, rule, sizes)];
  end
end

function p = checkOne (value, rule, sizes)
  field = ['optim.', rule.name];
  [values, fields, given] = checkElements (value, field);
  if isempty (given)
    p = checkProblem (rule.reason, field, ...
                      'a cell of numbers, {k}(i) for target i of model k', ...
                      checkShow (value), rule.cure);
    return
  end
  p = checkProblem ();
  for i = find (~rule.isGood (values))
    p(end + 1) = checkProblem (rule.reason, fields{i}, rule.expected, ...
                               checkShow (values(i)), rule.cure);
  end
  if ~isempty (sizes)
    p = [p, checkCount(iscell (value), given, rule, sizes)];
  end
end

function p = checkCount (isCell, given, rule, sizes)
  p = checkProblem ();
  if isCell && rule.optional
    given(end + 1:numel (sizes)) = 0;
    sizes(given(1:numel (sizes)) == 0) = 0;
  end
  if isCell
    fits = isequal (given, sizes);
  else
    fits = given == sum (sizes) || (given == 1 && ~rule.optional);
  end
  if ~fits
    p = checkProblem ([rule.name, 'Count'], ['optim.', rule.name], ...
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
