% EFFECTBIAS  Candidate effect of the laboratory: offset of measured heights.
%
% CALL: EFFECT = effectBias (), see describeEffect
function effect = effectBias ()
  given.name = 'bias';
  given.question = 'Is the zero of the height gauge off?';
  given.neutral = 0;
  given.limits = [-0.002; 0.002];
  given.unit = 'm';
  given.label = 'offset of the measured heights';
  given.group = 'gauge';
  given.laboratory = true;
  given.kinds = {'height'};
  given.transform = @showHigher;
  given.source = 'zero of a ruler or a laser line';
  effect = describeEffect (given);
end

% an offset on everything that is read as a height
function Z = showHigher (Z, strength, info)
  moved = strcmp ({info.kind}, 'height');
  Z(:, moved) = Z(:, moved) + strength;
end

%!test
%! info = struct ('kind', {'height', 'angle'});
%! assert (effectBias ().transform ([0.02, 30], 0.001, info), [0.021, 30], eps);

% SPDX-License-Identifier: GPL-3.0-only
