% CHECKVARIABLES  Checks the model variables and the design variables.
%
% CALL: P = checkVariables (MODELVARS, ASSIGN)
%
%   MODELVARS  [] (not usable) or a scalar struct, as loadInput returns it
%   ASSIGN     anything, as loadInput returns it
%   P          1 x n faults, see checkFault
%
% Reasons: badAssign badVariableName duplicateVariable reservedName
% overwrittenVariable similarVariable badModelVar impossibleValue
%
% See also: checkCase, checkLimits, checkDeclared

function p = checkVariables (modelVars, assign)
  p = checkFault ();
  fixed = {};
  if isstruct (modelVars)
    fixed = fieldnames (modelVars)';
  end
  if ~iscell (assign) || isempty (assign) || ~isvector (assign)
    p = checkFault ('badAssign', 'assign', ...
                    'a cell of names of variables', checkShow (assign), ...
                    'Write assign{1} = ''coefFrictionPP''; and so on.');
  else
    p = checkAssign (assign(:)', fixed);
  end
  for k = 1:numel (fixed)
    p = [p, checkModelVar(fixed{k}, modelVars.(fixed{k}))];
  end
end

function p = checkAssign (assign, fixed)
  p = checkFault ();
  isText = cellfun (@(a) checkIs ('text', a), assign);
  for k = 1:numel (assign)
    field = sprintf ('assign{%d}', k);
    earlier = assign(find (isText(1:k - 1)));
    q = checkName (field, assign{k});
    if isempty (q)
      q = checkTwice (field, assign{k}, earlier, fixed);
    end
    p = [p, q];
  end
end

function p = checkName (field, name)
  p = checkFault ();
  if ~checkIs ('name', name)
    p = checkFault ('badVariableName', field, ...
                    ['the name of a variable (letters, digits, _; no ' ...
                     'digit first)'], checkShow (name), ...
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
  if any (strcmp (name, earlier))
    p = checkFault ('duplicateVariable', field, ...
                    'every variable once', ...
                    sprintf ('%s a second time', name), ...
                    'Take one of the two out, and its column of paramLims.');
  elseif strcmp (name, 'percentRayleigh')
    p = checkFault ('reservedName', field, 'a property of the material', ...
                    name, ['Fix the time step as ' ...
                           'modelVars.percentRayleigh; it is numerics.']);
  elseif any (strcmp (name, fixed))
    p = checkFault ('overwrittenVariable', field, ...
                    'a variable that is set in one place', ...
                    sprintf ('%s, which modelVars.%s sets too', name, ...
                             name), ...
                    sprintf ('Take modelVars.%s out.', name));
  else
    same = strcmpi (name, [earlier, fixed]);
    others = [earlier, fixed];
    if any (same)
      p = checkFault ('similarVariable', field, ...
                      'names that differ by more than their case', ...
                      sprintf ('%s beside %s', name, ...
                               others{find(same, 1)}), ...
                      'Write both as data.head does, or take one out.');
    end
  end
end

function p = checkModelVar (name, value)
  field = ['modelVars.', name];
  p = checkName (field, name);
  if ~checkIs ('number', value)
    p(end + 1) = checkFault ('badModelVar', field, 'a finite number', ...
                             checkShow (value), ...
                             'Set one number in the SI unit of data.head.');
  elseif ~isempty (checkPhysics (name, double (value)))
    p(end + 1) = checkFault ('impossibleValue', field, ...
                             checkPhysics (name, double (value)), ...
                             checkShow (value), ...
                             'Mind the SI unit (m, kg, s, Pa).');
  end
end

%!shared vars
%! vars = struct ('radiusP', 2e-3, 'poissonsRatioP', 0.3);
%!assert (isempty (checkVariables (vars, {'densityP'; 'coefFrictionPP'})))
%!assert (checkVariables (vars, {'radiusP'}).id, ...
%!        'DEcalioc:checkCase:overwrittenVariable')
%!assert (checkVariables (vars, {'a', 'a'}).id, ...
%!        'DEcalioc:checkCase:duplicateVariable')
%!assert (checkVariables (vars, {'a b'}).id, ...
%!        'DEcalioc:checkCase:badVariableName')
%!assert (checkVariables (vars, {'SIMTS'}).id, ...
%!        'DEcalioc:checkCase:reservedName')
%!assert (checkVariables (vars, {'RadiusP'}).id, ...
%!        'DEcalioc:checkCase:similarVariable')
%!assert (checkVariables (struct ('densityP', -1), {'a'}).id, ...
%!        'DEcalioc:checkCase:impossibleValue')
%!assert (checkVariables ([], 'a').id, 'DEcalioc:checkCase:badAssign')
