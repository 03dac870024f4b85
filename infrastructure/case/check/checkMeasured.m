% CHECKMEASURED  Checks the parameters that were measured by themselves.
%
% CALL: P = checkMeasured (OPTIM, ASSIGN, PARAMLIMS)
%
%   OPTIM      scalar struct, the optim of loadInput
%   ASSIGN     anything; good is a cell of d names
%   PARAMLIMS  anything; good is 2 x d
%   P          1 x n faults, see checkFault
%
% optim.paramMean and optim.paramSd: value and standard uncertainty, 1 x d with
% NaN for what was not measured, or a struct with a field for each parameter
% that was.
%
% Reasons: badParamMean badParamSd paramCount unknownParam paramPair
% paramOutside

function p = checkMeasured (optim, assign, paramLims)
  names = {};
  if iscell (assign) && isvector (assign) && ...
      all (cellfun (@(a) checkIs ('name', a), assign))
    names = assign(:)';
  end
  rules = struct ('name', {'paramMean', 'paramSd'}, ...
                  'reason', {'badParamMean', 'badParamSd'}, ...
                  'expected', {'a finite number', ...
                               'a finite number above 0'}, ...
                  'isGood', {@(v) isfinite(v), @(v) v > 0 & isfinite(v)});
  p = checkFault ();
  for rule = rules
    if isfield (optim, rule.name) && ~checkIs ('nothing', optim.(rule.name))
      p = [p, checkOne(optim.(rule.name), rule, names)];
    else
      optim.(rule.name) = [];
    end
  end
  if isfield (optim, 'perCondition') && iscellstr (optim.perCondition)
    for own = setdiff (optim.perCondition(:)', names)
      p(end + 1) = checkFault ('unknownParam', 'optim.perCondition', ...
                               'design variables of assign', own{1}, ...
                               checkNearest (own{1}, names));
    end
  end
  if isempty (p) && ~isempty (names)
    p = checkPairs (rowByName (optim.paramMean, names), ...
                    rowByName (optim.paramSd, names), names, paramLims);
  end
end

function p = checkOne (value, rule, names)
  field = ['optim.', rule.name];
  cure = ['Write optim.paramMean.densityP = 650; optim.paramSd.densityP = ' ...
          '5; for what was measured.'];
  p = checkFault ();
  if checkIs ('struct', value)
    given = fieldnames (value)';
    fields = strcat (field, '.', given);
    values = cellfun (@(n) value.(n), given, 'UniformOutput', false);
  elseif checkIs ('vector', value)
    fields = arrayfun (@(j) sprintf ('%s(%d)', field, j), ...
                       1:numel (value), 'UniformOutput', false);
    values = num2cell (value(:)');
  else
    p = checkFault (rule.reason, field, ...
                    'one number a parameter, or a struct of numbers', ...
                    checkShow (value), cure);
    return
  end
  for j = find (~cellfun (@(v) isMissing (v) || (checkIs ('number', v) && ...
                                                 rule.isGood (v)), values))
    p(end + 1) = checkFault (rule.reason, fields{j}, ...
                             [rule.expected, ', or NaN'], ...
                             checkShow (values{j}), cure);
  end
  p = [p, checkWhose(value, field, names, cure)];
end

function yes = isMissing (v)
  yes = checkIs ('vector', v) && isscalar (v) && isnan (v);
end

function p = checkWhose (value, field, names, cure)
  p = checkFault ();
  if isempty (names)
    return
  end
  if isstruct (value)
    given = fieldnames (value)';
    for k = find (~ismember (given, names))
      hint = checkNearest (given{k}, names);
      p(end + 1) = checkFault ('unknownParam', [field, '.', given{k}], ...
                               'a design variable of assign', ...
                               'another name', strtrim ([hint, ' ', cure]));
    end
  elseif numel (value) ~= numel (names)
    p = checkFault ('paramCount', field, ...
                    sprintf ('%d value(s), one a name in assign', ...
                             numel (names)), ...
                    sprintf ('%d', numel (value)), cure);
  end
end

function p = checkPairs (value, sd, names, limits)
  p = checkFault ();
  hasLimits = isnumeric (limits) && ...
              isequal (size (limits), [2, numel(names)]);
  for j = find (~(isnan (value) & isnan (sd)))
    if isnan (value(j)) || isnan (sd(j))
      p(end + 1) = checkFault ('paramPair', ...
                               ['optim.paramMean and paramSd of ', ...
                                names{j}], 'both', 'one of the two', ...
                               ['Give value and standard uncertainty, or ' ...
                                'neither.']);
    elseif hasLimits && ...
        (value(j) < double (limits(1, j)) - 3 * sd(j) || ...
         value(j) > double (limits(2, j)) + 3 * sd(j))
      p(end + 1) = checkFault ('paramOutside', ...
                               ['optim.paramMean of ', names{j}], ...
                               ['a value within 3 standard deviations of ' ...
                                'paramLims ', checkShow(limits(:, j))], ...
                               checkShow (value(j)), ...
                               'Widen paramLims, or look at the unit.');
    end
  end
end

%!test
%! ids = @(m, s) {checkMeasured(struct ('paramMean', m, 'paramSd', s), ...
%!                              {'rho', 'mu'}, [500, 0; 800, 1]).id};
%! assert (isempty (ids ([600, NaN], [5; NaN])));
%! assert (isempty (ids (struct ('mu', 1.2), struct ('mu', 0.1))));
%! assert (isempty (ids ([], [])));
%! assert (ids (600, [5, NaN]), {'DEcalioc:checkCase:paramCount'});
%! assert (ids ([600, 0.4], [5, NaN]), {'DEcalioc:checkCase:paramPair'});
%! assert (ids (struct ('mu', 1.4), struct ('mu', 0.1)), ...
%!         {'DEcalioc:checkCase:paramOutside'});
%!assert (isempty (checkMeasured (struct ('paramMean', 600, 'paramSd', 5), ...
%!                                {'rho'}, @sin)))
%!assert (checkMeasured (struct ('perCondition', {{'mu'}}), {'rho'}, []).id, ...
%!        'DEcalioc:checkCase:unknownParam')
