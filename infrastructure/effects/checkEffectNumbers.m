% CHECKEFFECTNUMBERS  Checks variables, neutral values, limits of one effect.
%
% CALL: P = checkEffectNumbers (EFFECT, FIELD)
%
%   EFFECT  scalar struct, one effect of loadEffects
%   FIELD   how the user writes it, e.g. 'effects(2).' (text)
%   P       1 x n faults, see checkFault
%
% Reasons: missingField effectVariables effectTransform reservedName
% neutralShape effectLimitsShape effectLimits

function p = checkEffectNumbers (effect, field)
  [p, v] = checkNames (effect, [field, 'variables']);
  if isempty (p)
    p = [checkNeutral(effect, [field, 'neutral'], v), ...
         checkBounds(effect, [field, 'limits'], v)];
  end
end

function [p, v] = checkNames (effect, field)
  p = checkFault ();
  v = 1;
  expected = 'a cell of names of variables of data.head';
  cure = 'Write for example {''cohesionPP''}.';
  if isfield (effect, 'laboratory') && isequal (effect.laboratory, true)
    p = checkTransform (effect, strrep (field, 'variables', 'transform'));
    return
  end
  if ~isfield (effect, 'variables')
    p = checkFault ('missingField', field, expected, 'nothing', cure);
    return
  end
  names = effect.variables;
  if ~iscell (names) || ~isrow (names) || ...
      ~all (cellfun (@(n) checkIs ('name', n), names))
    p = checkFault ('effectVariables', field, expected, ...
                    checkShow (names), cure);
    return
  end
  v = numel (names);
  reserved = names(ismember (names, {'RLTS', 'SIMTS', 'runSeed'}));
  own = names(ismember (names, {'value', 'interval90', 'smallestSeen'}));
  if ~isempty (reserved)
    p = checkFault ('reservedName', field, ...
                    'a variable that DEcalioc does not set itself', ...
                    reserved{1}, 'Take it out.');
  elseif ~isempty (own)
    p = checkFault ('reservedName', field, ...
                    'a name that is none of gap.json''s own', own{1}, ...
                    'Call it something else, in data.head too.');
  end
end

function p = checkTransform (effect, field)
  p = checkFault ();
  if ~isfield (effect, 'transform') || ~is_function_handle (effect.transform)
    p = checkFault ('effectTransform', field, ...
                    ['a function handle Z = f (Z, strength, info), for ' ...
                     'the effect acts on results'], 'none', ...
                    'Take effectGain.m of the toolbox as a pattern.');
  end
end

function p = checkNeutral (effect, field, v)
  p = checkFault ();
  expected = sprintf ('a row of %d finite number(s), one a variable', v);
  cure = 'Set the values that switch the effect off.';
  if ~isfield (effect, 'neutral')
    p = checkFault ('missingField', field, expected, 'nothing', cure);
  elseif ~isMatrix (effect.neutral, [1, v])
    p = checkFault ('neutralShape', field, expected, ...
                    checkShow (effect.neutral), cure);
  end
end

function p = checkBounds (effect, field, v)
  p = checkFault ();
  expected = sprintf (['a 2 x %d matrix of finite numbers: weakest and ' ...
                       'strongest plausible values'], v);
  cure = 'Set the two rows, one column a variable.';
  if ~isfield (effect, 'limits')
    p = checkFault ('missingField', field, expected, 'nothing', cure);
  elseif ~isMatrix (effect.limits, [2, v])
    p = checkFault ('effectLimitsShape', field, expected, ...
                    checkShow (effect.limits), cure);
  elseif all (effect.limits(1, :) == effect.limits(2, :))
    p = checkFault ('effectLimits', field, ...
                    'a weakest value that is not the strongest', ...
                    checkShow (effect.limits(:)), ...
                    'Set the strongest plausible value in row 2.');
  end
end

function yes = isMatrix (value, shape)
  yes = isnumeric (value) && isreal (value) && ~issparse (value) && ...
        isequal (size (value), shape) && all (isfinite (value(:)));
end

%!shared e
%! e = struct ('variables', {{'a', 'b'}}, 'neutral', [0, 1], ...
%!             'limits', [0, 1; 5, 0.5]);
%!assert (isempty (checkEffectNumbers (e, 'effects(1).')))
%!assert (checkEffectNumbers (setfield (e, 'neutral', 0), 'effects(1).').id, ...
%!        'DEcalioc:checkCase:neutralShape')
%!test
%! bad = setfield (e, 'limits', [1, 2; 1, 2]);
%! assert (checkEffectNumbers (bad, 'effects(1).').id, ...
%!         'DEcalioc:checkCase:effectLimits');
%!test
%! own = struct ('laboratory', true, 'neutral', 0, 'limits', [-1; 1]);
%! assert (checkEffectNumbers (own, 'effects(1).').id, ...
%!         'DEcalioc:checkCase:effectTransform');
%! own.transform = @(Z, s, info) Z + s;
%! assert (isempty (checkEffectNumbers (own, 'effects(1).')));
%!assert (checkEffectNumbers (setfield (e, 'variables', {'a', 'value'}), ...
%!                             'e.').id, 'DEcalioc:checkCase:reservedName')
%!assert (checkEffectNumbers (struct ('variables', 'a'), 'e.').id, ...
%!        'DEcalioc:checkCase:effectVariables')
