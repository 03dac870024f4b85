% EFFECTCAMERAROLL  Candidate effect of the laboratory: roll of the camera.
%
% CALL: EFFECT = effectCameraRoll (), see describeEffect
function effect = effectCameraRoll ()
  given.name = 'cameraRoll';
  given.question = 'Was the camera level?';
  given.neutral = 0;
  given.limits = [-2; 2];
  given.unit = 'deg';
  given.label = 'camera turned to one side';
  given.group = 'alignment';
  given.laboratory = true;
  given.kinds = {'angle', 'angleFalling', 'height'};
  given.transform = @turnPicture;
  given.source = 'geometry; an unlevelled tripod';
  effect = describeEffect (given);
end

% surfaces that rise along x get steeper, those that fall get flatter; heights
% turn about the origin of the bench's positions
function Z = turnPicture (Z, strength, info)
  kinds = {info.kind};
  rising = strcmp (kinds, 'angle');
  falling = strcmp (kinds, 'angleFalling');
  Z(:, rising) = Z(:, rising) + strength;
  Z(:, falling) = Z(:, falling) - strength;
  known = strcmp (kinds, 'height') & ~isnan ([info.at]);
  Z(:, known) = Z(:, known) + [info(known).at] * strength * pi / 180;
end

%!test % two slopes, and a height read 0.1 m to the right of the origin
%! info = struct ('kind', {'angle', 'angleFalling', 'height'}, ...
%!                'at', {NaN, NaN, 0.1});
%! z = effectCameraRoll ().transform ([30, 30, 0.02], 1, info);
%! assert (z, [31, 29, 0.02 + 0.1 * pi / 180], 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
