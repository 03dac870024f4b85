% EFFECTCAMERAROLL  Candidate effect of the laboratory: roll of the camera.
%
% CALL: EFFECT = effectCameraRoll ()
%
% EFFECT  scalar struct, see describeEffect
%
% Was the camera level?
% Acts on results, needs no DEM run.
%
% See also: describeEffect, resultInfo
function effect = effectCameraRoll ()
  given.name = 'cameraRoll';
  given.question = 'Was the camera level?';
  given.neutral = 0;
  given.limits = [-2; 2];
  given.unit = 'deg';
  given.label = 'roll of the camera';
  given.confusedWith = {'tilt'};
  given.group = 'alignment';
  given.laboratory = true;
  given.kinds = {'angle', 'height'};
  given.transform = @turnPicture;
  given.source = 'geometry; an unlevelled tripod';
  effect = describeEffect (given);
end

% angles turn; heights turn about the origin of the bench's positions
function Z = turnPicture (Z, strength, info)
  moved = strcmp ({info.kind}, 'angle');
  Z(:, moved) = Z(:, moved) + strength;
  known = strcmp ({info.kind}, 'height') & ~isnan ([info.at]);
  Z(:, known) = Z(:, known) - [info(known).at] * strength * pi / 180;
end

%!test % a slope, and a height read 0.1 m to the right of the origin
%! info = struct ('kind', {'angle', 'height'}, 'at', {NaN, 0.1});
%! z = effectCameraRoll ().transform ([30, 0.02], 1, info);
%! assert (z, [31, 0.02 - 0.1 * pi / 180], 1e-12);
