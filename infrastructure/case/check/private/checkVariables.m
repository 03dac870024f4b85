% CHECKVARIABLES  Checks the model variables, the design variables, the limits.
%
% CALL: P = checkVariables (MODELVARS, ASSIGN, PARAMLIMS, NUMOFSAM)
%
%   MODELVARS  [] (not usable) or a scalar struct, as loadInput returns it
%   ASSIGN     anything; good is a cell of d names
%   PARAMLIMS  anything; good is 2 x d, lower limits above upper ones
%   NUMOFSAM   anything; good is an integer, the samples of the plan
%   P          1 x n faults, see checkFault

function p = checkVariables (modelVars, assign, paramLims, numOfSam)
  p = checkFault ();
  [fixed, names] = deal ({});
  if isstruct (modelVars)
    fixed = fieldnames (modelVars)';
  end
  if iscell (assign) && isvector (assign)
    names = assign(:)';
  end
  if isempty (names)
    p = checkFault ('badAssign', 'assign', ...
                    'a cell of names of variables', describeValue (assign), ...
                    'Write assign{1} = ''coefFrictionPP''; and so on.');
  end
  isText = cellfun (@(a) isKind ('text', a), names);
  for k = 1:numel (names)
    field = sprintf ('assign{%d}', k);
    q = checkName (field, names{k});
    if isempty (q)
      q = checkTwice (field, names{k}, names(find (isText(1:k - 1))), fixed);
    end
    p = [p, q];
  end
  for name = fixed
    p = [p, checkModelVar(name{1}, modelVars.(name{1}))];
  end
  p = [p, checkLimits(paramLims, names, numOfSam)];
end

function p = checkName (field, name)
  p = checkFault ();
  if ~isKind ('name', name)
    p = checkFault ('badVariableName', field, ...
                    ['the name of a variable (letters, digits, _; no ' ...
                     'digit first)'], describeValue (name), ...
                    'Write the name as data.head declares it.');
  elseif any (strcmp (name, {'RLTS', 'SIMTS', 'runSeed'}))
    p = checkFault ('reservedName', field, ...
                    'a variable that DEcalioc does not set itself', name, ...
                    ['Take it out: RLTS, SIMTS and runSeed are written ' ...
                     'for every run.']);
  end
end

function p = checkTwice (field, name, earlier, fixed)
  p = checkFault ();
  others = [earlier, fixed];
  same = others(strcmpi (name, others));
  if any (strcmp (name, earlier))
    p = checkFault ('duplicateVariable', field, 'every variable once', ...
                    [name, ' a second time'], ...
                    'Take one of the two out, and its column of paramLims.');
  elseif strcmp (name, 'percentRayleigh')
    p = checkFault ('reservedName', field, 'a property of the material', ...
                    name, ['Fix the time step as ' ...
                           'modelVars.percentRayleigh; it is numerics.']);
  elseif any (strcmp (name, fixed))
    p = checkFault ('overwrittenVariable', field, ...
                    'a variable that is set in one place', ...
                    sprintf ('%s, which modelVars.%s sets too', name, name), ...
                    sprintf ('Take modelVars.%s out.', name));
  elseif ~isempty (same)
    p = checkFault ('similarVariable', field, ...
                    'names that differ by more than their case', ...
                    [name, ' beside ', same{1}], ...
                    'Write both as data.head does, or take one out.');
  end
end

function p = checkModelVar (name, value)
  field = ['modelVars.', name];
  p = checkName (field, name);
  if isKind ('number', value)
    p = [p, checkPhysics(name, double (value), field)];
  else
    p(end + 1) = checkFault ('badModelVar', field, 'a finite number', ...
                             describeValue (value), ...
                             'Set one number in the SI unit of data.head.');
  end
end

% What a variable of a known name may be. The ranges of restitution and
% Poisson's ratio are those that LIGGGHTS takes.
function p = checkPhysics (name, values, field)
  table = {'density|radius|youngsModulus', 'a number above 0', ...
           @(v) v > 0; ...
           'poissonsRatio', 'a number from 0 to 0.5', ...
           @(v) v >= 0 & v <= 0.5; ...
           'coefRestitution', 'a number above 0.05, at most 1', ...
           @(v) v > 0.05 & v <= 1; ...
           'coef(Rolling)?Friction', 'a number from 0', @(v) v >= 0; ...
           'percentRayleigh', 'a number above 0, at most 1', ...
           @(v) v > 0 & v <= 1};
  p = checkFault ();
  for row = table'
    kind = ['^(', row{1}, ')(PP|PW|WW|P|W)?$'];
    if isKind ('name', name) && ~isempty (regexp (name, kind)) && ...
       ~all (row{3} (values))
      p = checkFault ('impossibleValue', field, row{2}, ...
                      describeValue (values), 'Mind the SI unit (m, kg, s, Pa).');
    end
  end
end

function p = checkLimits (limits, names, numOfSam)
  cure = ['Write paramLims(:, j) = [lower; upper]; in the order of assign, ' ...
          'j = 1, 2, ...'];
  if ~isnumeric (limits) || ~isKind ('vector', limits(:)) || ...
      ~isequal (size (limits), [2, columns(limits)])
    p = checkFault ('limitsShape', 'paramLims', ...
                    'a 2 x d matrix of real numbers', ...
                    describeValue (limits), cure);
    return
  end
  p = checkFault ();
  d = columns (limits);
  if ~isempty (names) && numel (names) ~= d
    p = checkFault ('limitsCount', 'paramLims', ...
                    sprintf ('%d column(s), one a name in assign', ...
                             numel (names)), sprintf ('%d', d), cure);
  end
  names(end + 1:d) = {''};
  for j = 1:d
    p = [p, checkColumn(double (limits(:, j)), names{j}, j)];
  end
  if isKind ('integer', numOfSam) && numOfSam >= 1 && numOfSam < d + 1
    p(end + 1) = checkFault ('tooFewSamples', 'Input.numOfSam', ...
                             sprintf (['at least %d for %d design ' ...
                                       'variables'], d + 1, d), ...
                             describeValue (numOfSam), ...
                             sprintf ('%d are usual.', d + 3));
  end
end

function p = checkColumn (limits, name, j)
  field = sprintf ('paramLims(:, %d)', j);
  if isKind ('name', name)
    field = sprintf ('%s (%s)', field, name);
  end
  if ~all (isfinite (limits))
    p = checkFault ('limitsNotFinite', field, 'two finite numbers', ...
                    describeValue (limits), ...
                    'Set the widest range that is physically sensible.');
  elseif any (abs (limits) > 1e150)
    p = checkFault ('limitsNotFinite', field, ...
                    'numbers of a size that can be squared, up to 1e150', ...
                    describeValue (limits), ...
                    'Set the widest range that is physically sensible.');
  elseif ~(diff (limits) > 1e-9 * max (abs (limits)))
    p = checkFault ('badLimits', field, ...
                    'a lower limit and below it a larger upper one', ...
                    describeValue (limits), ...
                    ['Swap them; a variable that is fixed belongs into ' ...
                     'modelVars.']);
  else
    p = checkPhysics (name, limits, field);
  end
end

%!test
%! ids = @(p) arrayfun (@(q) strrep (q.id, 'DEcalioc:checkCase:', ''), ...
%!                      p(:)', 'UniformOutput', false);
%! vars = struct ('radiusP', 2e-3, 'poissonsRatioP', 0.3);
%! check = @(names, limits) ids (checkVariables (vars, names, limits, 21));
%! assert (check ({'densityP'; 'mu'}, [1, 2; 3, 4]), cell (1, 0));
%! assert (check ({'a', 'a'}, [1, 2; 3, 4]), {'duplicateVariable'});
%! assert (check ({'RadiusP'}, [1; 1]), {'similarVariable', 'badLimits'});
%! assert (check ({'densityP'}, [-1; 2]), {'impossibleValue'});
%! assert (check ({'a'}, [-1e308; 1e308]), {'limitsNotFinite'});
%! assert (ids (checkVariables (struct ('densityP', -1), 'a', [1; 2], 1)), ...
%!         {'badAssign', 'impossibleValue', 'tooFewSamples'});
%! assert (ids (checkVariables (vars, {'mu'}, [1; 2], 2)), cell (1, 0));

% SPDX-License-Identifier: GPL-3.0-only
