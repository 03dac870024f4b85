% CHECKSCALARS  Checks those fields of a struct that hold one number each.
%
% CALL: P = checkScalars (S, PREFIX, RULES)
%
%   S       scalar struct
%   PREFIX  how the user writes it, e.g. 'optim' (text)
%   RULES   n x 7 cell, one row a field: name, reason, low, high, kind
%           ('integer', 'number' or 'open': between the limits, limits
%           excluded), needed (true or false), cure (text)
%   P       1 x m faults, see checkFault
%
% A field that is not needed may be missing or empty.
%
% See also: checkInputFields, checkOptim

function p = checkScalars (s, prefix, rules)
  p = checkFault ();
  for k = 1:size (rules, 1)
    p = [p, checkOne(s, prefix, rules(k, :))];
  end
end

function p = checkOne (s, prefix, rule)
  p = checkFault ();
  [name, reason, low, high, kind, needed, cure] = rule{:};
  field = [prefix, '.', name];
  if ~isfield (s, name)
    if needed
      p = checkFault ('missingField', field, expected (low, high, kind), ...
                      'nothing', cure);
    end
    return
  end
  value = s.(name);
  if ~needed && checkIs ('nothing', value)
    return
  end
  if ~isInside (value, low, high, kind)
    p = checkFault (reason, field, expected (low, high, kind), ...
                    checkShow (value), cure);
  end
end

function yes = isInside (value, low, high, kind)
  yes = checkIs ('number', value) && value >= low && value <= high;
  if yes && strcmp (kind, 'integer')
    yes = value == fix (value);
  elseif yes && strcmp (kind, 'open')
    yes = value > low && value < high;
  end
end

function text = expected (low, high, kind)
  what = 'a number';
  if strcmp (kind, 'integer')
    what = 'an integer';
  end
  text = sprintf ('%s from %.10g to %.10g', what, low, high);
  if strcmp (kind, 'open')
    text = sprintf ('a number between %.10g and %.10g', low, high);
  end
end

%!shared rules
%! rules = {'n', 'badN', 1, 9, 'integer', true, 'Set n = 2.'; ...
%!          'x', 'badX', 0, 1, 'open', false, 'Set x = 0.5.'};
%!assert (isempty (checkScalars (struct ('n', 3), 'optim', rules)))
%!assert (isempty (checkScalars (struct ('n', 3, 'x', []), 'optim', rules)))
%!test
%! p = checkScalars (struct ('x', 0), 'optim', rules);
%! assert ({p.id}, {'DEcalioc:checkCase:missingField', ...
%!                  'DEcalioc:checkCase:badX'});
%! assert (p(2).message, ['optim.x in loadInput.m: expected a number ', ...
%!                        'between 0 and 1, got 0. Set x = 0.5.']);
%!assert (checkScalars (struct ('n', 2.5), 'optim', rules).id, ...
%!        'DEcalioc:checkCase:badN')
