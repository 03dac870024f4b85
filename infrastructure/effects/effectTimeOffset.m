% EFFECTTIMEOFFSET  Candidate effect of the laboratory: offset of the clock.
%
% CALL: EFFECT = effectTimeOffset (), see describeEffect
function effect = effectTimeOffset ()
  given.name = 'timeOffset';
  given.question = 'Does the clock start too late or too early?';
  given.neutral = 0;
  given.limits = [-0.03; 0.03];
  given.unit = 's';
  given.label = 'offset of the clock';
  given.group = 'clock';
  given.laboratory = true;
  given.kinds = {'time'};
  given.transform = @readLater;
  given.source = 'reaction time of a hand, trigger of a camera';
  effect = describeEffect (given);
end

% durations grow by the offset; a curve over time is read earlier
function Z = readLater (Z, strength, info)
  Z = shiftSeries (Z, -strength, info, 'time');
  moved = strcmp ({info.kind}, 'time');
  Z(:, moved) = Z(:, moved) + strength;
end

%!test % a duration; a curve that falls by 3 kg/s; an angle
%! info = struct ('kind', {'time', 'mass', 'mass', 'angle'}, 'at', ...
%!                {NaN, 1, 2, NaN}, 'series', {'', 'time', 'time', ''});
%! z = effectTimeOffset ().transform ([5, 9, 6, 30], 0.1, info);
%! assert (z, [5.1, 9.3, 6.3, 30], 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
