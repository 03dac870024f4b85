% CHECKMEASURED  Checks the parameters that were measured by themselves.
%
% CALL: [P, MIDDLE, SD] = checkMeasured (OPTIM, ASSIGN, PARAMLIMS)
%
%   OPTIM       scalar struct, the optim of loadInput
%   ASSIGN      anything; good is a cell of d names
%   PARAMLIMS   anything; good is 2 x d
%   P           1 x n faults, see checkFault
%   MIDDLE, SD  1 x d, value and standard uncertainty, NaN: not measured; []
%               where they make no sense
%
% optim.paramMean and paramSd: 1 x d with NaN for what was not measured, or a
% struct with a field for each parameter that was.

function [p, middle, sd] = checkMeasured (optim, assign, paramLims)
  [middle, sd] = deal ([]);
  names = {};
  if iscell (assign) && isvector (assign) && ...
      all (cellfun (@(a) isKind ('name', a), assign))
    names = assign(:)';
  end
  % name, expected, whether a number is good
  rules = {'paramMean', 'a finite number, or NaN', @(v) ~isinf (v); ...
           'paramSd', 'a finite number above 0, or NaN', ...
           @(v) ~isinf (v) && ~(v <= 0)};
  p = checkFault ();
  for rule = rules'
    if isfield (optim, rule{1}) && ~isKind ('nothing', optim.(rule{1}))
      p = [p, checkOne(optim.(rule{1}), names, rule{:})];
    else
      optim.(rule{1}) = [];
    end
  end
  if isfield (optim, 'perCondition') && iscellstr (optim.perCondition)
    p = [p, checkKnown(optim.perCondition(:)', names, ...
                       'optim.perCondition, ', '')];
  end
  if isempty (p) && ~isempty (names)
    middle = rowByName (optim.paramMean, names);
    sd = rowByName (optim.paramSd, names);
    p = checkPairs (middle, sd, names, paramLims);
  end
end

function row = rowByName (value, names)
  row = NaN (1, numel (names));
  if isstruct (value)
    for j = find (isfield (value, names))
      row(j) = double (value.(names{j}));
    end
  else
    row(1:numel (value)) = double (value(:)');
  end
end

function p = checkOne (value, names, name, expected, isGood)
  field = ['optim.', name];
  reason = ['bad', upper(name(1)), name(2:end)];
  cure = ['Write optim.paramMean.densityP = 650; optim.paramSd.densityP = ' ...
          '5; for what was measured.'];
  isNamed = isKind ('struct', value);
  if isNamed
    given = fieldnames (value)';
    fields = strcat (field, '.', given);
    values = struct2cell (value)';
  elseif isKind ('vector', value)
    [values, fields] = checkElements (value, field, 'column');
  else
    p = checkFault (reason, field, ...
                    'one number a parameter, or a struct of numbers', ...
                    describeValue (value), cure);
    return
  end
  p = checkFault ();
  for j = find (~cellfun (@(v) isKind ('vector', v) && isscalar (v) && ...
                          isGood (v), values))
    p(end + 1) = checkFault (reason, fields{j}, expected, ...
                             describeValue (values{j}), cure);
  end
  if isNamed && ~isempty (names)
    p = [p, checkKnown(given, names, [field, '.'], cure)];
  elseif ~isempty (names) && numel (value) ~= numel (names)
    p(end + 1) = checkFault ('paramCount', field, ...
                             sprintf ('%d value(s), one a name in assign', ...
                                      numel (names)), ...
                             sprintf ('%d', numel (value)), cure);
  end
end

function p = checkKnown (given, names, prefix, cure)
  p = checkFault ();
  for name = given(~ismember (given, names))
    p(end + 1) = checkFault ('unknownParam', [prefix, name{1}], ...
                             'a design variable of assign', 'another name', ...
                             strtrim ([checkNearest(name{1}, names), ' ', ...
                                       cure]));
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
                                'paramLims ', describeValue(limits(:, j))], ...
                               describeValue (value(j)), ...
                               'Widen paramLims, or look at the unit.');
    end
  end
end

%!test
%! ids = @(m, s) {checkMeasured(struct ('paramMean', m, 'paramSd', s), ...
%!                              {'rho', 'mu'}, [500, 0; 800, 1]).id};
%! assert (isempty (ids ([600, NaN], [5; NaN])));
%! assert (isempty (ids (struct ('mu', 1.2), struct ('mu', 0.1))));
%! given = struct ('paramMean', struct ('mu', 1.2), 'paramSd', [NaN; 0.1]);
%! [~, middle, sd] = checkMeasured (given, {'rho', 'mu'}, []);
%! assert ([middle; sd], [NaN, 1.2; NaN, 0.1]);
%! assert (isempty (ids ([], [])));
%! assert (ids (600, [5, NaN]), {'DEcalioc:checkCase:paramCount'});
%! assert (ids ([600, 0.4], [5, NaN]), {'DEcalioc:checkCase:paramPair'});
%! assert (ids (struct ('mu', 1.4), struct ('mu', 0.1)), ...
%!         {'DEcalioc:checkCase:paramOutside'});
%!assert (isempty (checkMeasured (struct ('paramMean', 600, 'paramSd', 5), ...
%!                                {'rho'}, @sin)))
%!assert (checkMeasured (struct ('perCondition', {{'mu'}}), {'rho'}, []).id, ...
%!        'DEcalioc:checkCase:unknownParam')

% SPDX-License-Identifier: GPL-3.0-only
