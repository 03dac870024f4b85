% NEWEFFECT  Fills the description of one candidate effect.
%
% CALL: EFFECT = newEffect (GIVEN, T)
%
%   GIVEN   struct with name and, for an effect that DEM runs, variables (cell
%           of v names), neutral (1 x v) and limits (2 x v); or, for an effect
%           of the laboratory, laboratory = true and offset and/or matrix
%   T       scalar, number of targets
%   EFFECT  struct, every field present:
%     name, label, unit, group (text), variables, neutral, limits, laboratory,
%     saysName  see describeEffect
%     siblings  cellstr, effects that look alike (may be absent from the list)
%     offset    1 x T, matrix T x T: the result m becomes
%               m + phi * (offset + m * matrix)      (laboratory only)
%     offsetSd  1 x T, standard deviation of offset (0)
%     strongest  scalar, value of the effect at phi = 1 (laboratory only; 1)
%     range     1 x 2, strength phi: [0, 1], or [-1, 1] where neutral lies
%               inside the limits or the laboratory may err both ways
%     factor    what its prior probability is multiplied by, against that of
%               the others (1)
%     scale     prior scale of |phi| (2, nearly flat: the limits
%               are what is plausible): phi is half-normal (normal, where
%               signed), cut to the range
%
% phi = 1 is the limit that lies further from neutral (the upper one where the
% effect is signed), phi = -1 the lower one. Strength between is linear.
%
% Errors: DEcalioc:newEffect:missingField, DEcalioc:newEffect:badShape

function effect = newEffect (given, T)
  if ~isfield (given, 'name')
    error ('DEcalioc:newEffect:missingField', ...
           'newEffect: an effect must have the field name.');
  end
  effect = struct ('name', given.name, 'label', given.name, 'unit', '', ...
                   'saysName', ~isfield (given, 'label'), 'group', '', ...
                   'variables', {{}}, 'neutral', [], 'limits', zeros (2, 0), ...
                   'laboratory', false, 'siblings', {{}}, 'offset', zeros (1, T), ...
                   'offsetSd', zeros (1, T), 'matrix', zeros (T), ...
                   'strongest', 1, 'range', [], 'scale', 2, 'factor', 1);
  fields = fieldnames (effect);
  for k = 1:numel (fields)
    if isfield (given, fields{k}) && ~isempty (given.(fields{k}))
      effect.(fields{k}) = given.(fields{k});
    end
  end
  v = numel (effect.variables);
  if ~effect.laboratory && (v == 0 || numel (effect.neutral) ~= v || ...
                            ~isequal (size (effect.limits), [2, v]))
    error ('DEcalioc:newEffect:badShape', ...
           ['newEffect: effect %s must have neutral 1 x %d and limits 2 x ' ...
            '%d for its %d variables.'], effect.name, v, v, v);
  end
  if ~effect.laboratory             % one that acts both ways: the lower limit first
    both = min (effect.limits, [], 1) < effect.neutral & ...
           effect.neutral < max (effect.limits, [], 1);
    effect.limits(:, both) = sort (effect.limits(:, both), 1);
  end
  if isempty (effect.range)
    effect.range = rangeOf (effect);
  end
end

function range = rangeOf (effect)
  range = [0, 1];
  inside = effect.limits(1, :) < effect.neutral & ...
           effect.neutral < effect.limits(2, :);
  if effect.laboratory || (~isempty (inside) && all (inside))
    range = [-1, 1];
  end
end

%!test
%! e = newEffect (struct ('name', 'cohesion', 'variables', {{'ced'}}, ...
%!                        'neutral', 0, 'limits', [1e4; 1e5]), 3);
%! assert ({e.range, e.saysName}, {[0, 1], true});
%! assert (newEffect (getEffect ('cohesion'), 1).saysName);
%! assert (~newEffect (getEffect ('gain'), 1).saysName);
%! e = newEffect (struct ('name', 'size', 'variables', {{'factor'}}, ...
%!                        'neutral', 1, 'limits', [0.8; 1.25]), 3);
%! assert (e.range, [-1, 1]);
%! e = newEffect (struct ('name', 'size', 'variables', {{'factor'}}, ...
%!                        'neutral', 1, 'limits', [1.25; 0.8]), 3);
%! assert (e.limits, [0.8; 1.25]);
%! assert (e.range, [-1, 1]);
%! e = newEffect (struct ('name', 'gain', 'laboratory', true, ...
%!                        'matrix', 0.1 * eye (3)), 3);
%! assert (e.offset, zeros (1, 3));
%!error id=DEcalioc:newEffect:badShape newEffect (struct ('name', 'x'), 3)
%!error id=DEcalioc:newEffect:missingField newEffect (struct ('a', 1), 3)

% SPDX-License-Identifier: GPL-3.0-only
