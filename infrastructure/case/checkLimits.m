% CHECKLIMITS  Checks the limits of the design variables.
%
% CALL: P = checkLimits (PARAMLIMS, ASSIGN, NUMOFSAM)
%
%   PARAMLIMS  anything; good is 2 x d, lower limits above upper ones
%   ASSIGN     anything; good is a cell of d names
%   NUMOFSAM   anything; good is an integer, the samples of the plan
%   P          1 x n faults, see checkFault
%
% Reasons: limitsShape limitsCount limitsNotFinite badLimits impossibleValue
% tooFewSamples
%
% See also: checkCase, checkVariables

function p = checkLimits (paramLims, assign, numOfSam)
  cure = ['Write paramLims(:, j) = [lower; upper]; in the order of assign, ' ...
          'j = 1, 2, ...'];
  if ~isTwoRows (paramLims)
    p = checkFault ('limitsShape', 'paramLims', ...
                    'a 2 x d matrix of real numbers', ...
                    checkShow (paramLims), cure);
    return
  end
  p = checkFault ();
  names = {};
  if iscell (assign) && isvector (assign)
    names = assign(:)';
  end
  d = columns (paramLims);
  if ~isempty (names) && numel (names) ~= d
    p = checkFault ('limitsCount', 'paramLims', ...
                    sprintf ('%d column(s), one a name in assign', ...
                             numel (names)), sprintf ('%d', d), cure);
  end
  names(end + 1:d) = {''};
  for j = 1:d
    p = [p, checkColumn(double (paramLims(:, j)), names{j}, j)];
  end
  if checkIs ('integer', numOfSam) && numOfSam >= 1 && numOfSam < d + 2
    p(end + 1) = checkFault ('tooFewSamples', 'Input.numOfSam', ...
                             sprintf (['at least %d for %d design ' ...
                                       'variables'], d + 2, d), ...
                             checkShow (numOfSam), ...
                             sprintf ('About %d are usual.', 5 * d));
  end
end

function yes = isTwoRows (value)
  yes = isnumeric (value) && ~issparse (value) && isreal (value) && ...
        ndims (value) == 2 && rows (value) == 2 && ~isempty (value);
end

function p = checkColumn (limits, name, j)
  p = checkFault ();
  field = sprintf ('paramLims(:, %d)', j);
  if checkIs ('name', name)
    field = sprintf ('%s (%s)', field, name);
  end
  if ~all (isfinite (limits))
    p = checkFault ('limitsNotFinite', field, 'two finite numbers', ...
                    checkShow (limits), ...
                    'Set the widest range that is physically sensible.');
  elseif ~(diff (limits) > 1e-9 * max (abs (limits)))
    p = checkFault ('badLimits', field, ...
                    'a lower limit and below it a larger upper one', ...
                    checkShow (limits), ...
                    ['Swap them; a variable that is fixed belongs into ' ...
                     'modelVars.']);
  else
    for i = 1:2
      expected = checkPhysics (name, limits(i));
      if ~isempty (expected)
        p(end + 1) = checkFault ('impossibleValue', field, expected, ...
                                 checkShow (limits), ...
                                 'Mind the SI unit (m, kg, s, Pa).');
        return
      end
    end
  end
end

%!assert (isempty (checkLimits ([1, 2; 3, 4], {'a', 'b'}, 21)))
%!assert (checkLimits ([1; 1], {'a'}, 21).id, 'DEcalioc:checkCase:badLimits')
%!assert (checkLimits ([1; NaN], {'a'}, 21).id, ...
%!        'DEcalioc:checkCase:limitsNotFinite')
%!assert (checkLimits ([1, 2], {'a'}, 21).id, 'DEcalioc:checkCase:limitsShape')
%!assert (checkLimits ([1, 1; 2, 2], {'a'}, 21).id, ...
%!        'DEcalioc:checkCase:limitsCount')
%!assert (checkLimits ([-1; 2], {'densityP'}, 21).id, ...
%!        'DEcalioc:checkCase:impossibleValue')
%!assert (checkLimits ([1; 2], {'a'}, 2).id, ...
%!        'DEcalioc:checkCase:tooFewSamples')
