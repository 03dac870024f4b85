% CHECKEFFECTNUMBERS  Checks variables, neutral values, limits of one effect.
%
% CALL: P = checkEffectNumbers (EFFECT, FIELD)
%
%   EFFECT  scalar struct, one effect of loadEffects
%   FIELD   how the user writes it, e.g. 'effects(2)' (text)
%   P       1 x n faults, see checkFault
%
% Reasons: missingField effectVariables effectTransform reservedName
% neutralShape effectLimitsShape effectLimits

function p = checkEffectNumbers (effect, field)
  v = 1;
  known = fieldnames (effect)';
  if isfield (effect, 'laboratory') && isequal (effect.laboratory, true)
    p = checkTransform (effect, [field, '.transform']);
  else
    isNames = @(x) iscell (x) && isrow (x) && ...
                   all (cellfun (@(n) isKind ('name', n), x));
    p = checkFields (effect, field, known, ...
                     {'variables', 'effectVariables', ...
                      'a cell of names of variables of data.head', ...
                      isNames, 'other', true, ...
                      'Write for example {''cohesionPP''}.'});
    if isempty (p)
      v = numel (effect.variables);
      p = checkReserved (effect.variables, [field, '.variables']);
    end
  end
  if ~isempty (p)
    return
  end
  isLimits = @(x) isMatrix (x, [2, v]);
  p = checkFields (effect, field, known, ...
                   {'neutral', 'neutralShape', ...
                    sprintf('a row of %d finite number(s), one a variable', ...
                            v), @(x) isMatrix(x, [1, v]), 'other', true, ...
                    'Set the values that switch the effect off.'; ...
                    'limits', 'effectLimitsShape', ...
                    sprintf(['a 2 x %d matrix of finite numbers: weakest ' ...
                             'and strongest plausible values'], v), ...
                    isLimits, 'other', true, ...
                    'Set the two rows, one column a variable.'});
  if isempty (p) && isReversed (effect)
    p = checkFault ('effectLimits', [field, '.limits'], ...
                    'a strongest value (row 2) further from neutral than the weakest', ...
                    describeValue (effect.limits(:)), ...
                    'Exchange the rows, or set neutral to what switches the effect off.');
  end
  if isfield (effect, 'limits') && isLimits (effect.limits) && ...
      all (effect.limits(1, :) == effect.limits(2, :))
    p(end + 1) = checkFault ('effectLimits', [field, '.limits'], ...
                             'a weakest value that is not the strongest', ...
                             describeValue (effect.limits(:)), ...
                             'Set the strongest plausible value in row 2.');
  end
end

% Where neutral lies between them, either way is strong.
function yes = isReversed (effect)
  far = abs (effect.limits - effect.neutral);
  isBetween = min (effect.limits, [], 1) < effect.neutral & ...
              effect.neutral < max (effect.limits, [], 1);
  yes = any (far(1, :) > far(2, :) & ~isBetween);
end

function p = checkReserved (names, field)
  p = checkFault ();
  set = names(ismember (names, {'RLTS', 'SIMTS', 'runSeed'}));
  written = names(ismember (names, {'value', 'interval90', 'smallestSeen'}));
  if ~isempty (set)
    p = checkFault ('reservedName', field, ...
                    'a variable that DEcalioc does not set itself', set{1}, ...
                    'Take it out.');
  elseif ~isempty (written)
    p = checkFault ('reservedName', field, ...
                    'a name that is none of gap.json''s own', written{1}, ...
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

function yes = isMatrix (value, shape)
  yes = isnumeric (value) && isreal (value) && ~issparse (value) && ...
        isequal (size (value), shape) && all (isfinite (value(:)));
end

%!shared idOf, e
%! idOf = @(e) strrep (checkEffectNumbers (e, 'effects(1)').id, ...
%!                     'DEcalioc:checkCase:', '');
%! e = struct ('variables', {{'a', 'b'}}, 'neutral', [0, 1], ...
%!             'limits', [0, 1; 5, 0.5]);
%!assert (isempty (checkEffectNumbers (e, 'effects(1)')))
%!assert (idOf (setfield (e, 'neutral', 0)), 'neutralShape')
%!assert (idOf (setfield (e, 'limits', [1, 2; 1, 2])), 'effectLimits')
%!assert (idOf (setfield (e, 'limits', [5, 0.5; 0, 1])), 'effectLimits')
%!assert (idOf (setfield (e, 'variables', {'a', 'value'})), 'reservedName')
%!assert (idOf (struct ('variables', 'a')), 'effectVariables')
%!test
%! e = struct ('laboratory', true, 'neutral', 0, 'limits', [-1; 1]);
%! assert (idOf (e), 'effectTransform');
%! e.transform = @(Z, s, info) Z + s;
%! assert (isempty (checkEffectNumbers (e, 'effects(1)')));

% SPDX-License-Identifier: GPL-3.0-only
