% EFFECTCAMERA  Candidate effect of the laboratory: low parts read too high.
%
% CALL: EFFECT = effectCamera ()
%
% EFFECT  scalar struct, see describeEffect
%
% A camera above the surface sees low parts of it higher in the picture: by the
% strength on the floor, by nothing at the height of the column. Acts on
% results, needs no DEM run.
%
% See also: describeEffect, loadEffects
function effect = effectCamera ()
  given.name = 'camera';
  given.question = 'Does the camera look from above?';
  given.neutral = 0;
  given.limits = [-0.1; 0.1];
  given.unit = 'column heights';
  given.label = 'floor read too high';
  given.group = 'camera';
  given.laboratory = true;
  given.kinds = {'height'};
  given.transform = @seeHigher;
  given.source = 'profiles of all series read low parts about 0.05 too high';
  effect = describeEffect (given);
end

function Z = seeHigher (Z, strength, info)
  own = strncmp ({info.series}, 'profile', 7);
  Z(:, own) = Z(:, own) + strength * (1 - Z(:, own));
end

%!test
%! info = struct ('series', {'profile', ''});
%! assert (effectCamera ().transform ([0.5, 3], 0.1, info), [0.55, 3], eps);

% SPDX-License-Identifier: GPL-3.0-only
