% EFFECTOPTICS  Candidate effect of the laboratory: a surface read too far out.
%
% CALL: EFFECT = effectOptics ()
%
% EFFECT  scalar struct, see describeEffect
%
% Does the picture show the surface above or below the grains, normal to it:
% by the threshold, dust on the windows, grains that stick to them?
% Acts on results, needs no DEM run.
%
% See also: describeEffect, loadEffects
function effect = effectOptics ()
  given.name = 'optics';
  given.question = 'Does the picture show the surface where the grains end?';
  given.neutral = 0;
  given.limits = [-2; 2];
  given.priorScale = 2;
  given.unit = 'mm';
  given.label = 'offset of the surface in the picture, normal to it';
  given.group = 'optics';
  given.laboratory = true;
  given.kinds = {'height'};
  given.transform = @moveOut;
  given.source = ['the bed''s silhouette overstates its volume by about ' ...
                  '14 %: 3.5 mm of its height'];
  effect = describeEffect (given);
end

% Heights move by the offset over the cosine of the measured slopes, 41 and 55
% degrees in the middle.
function Z = moveOut (Z, strength, info)
  series = {info.series};
  slow = strncmp (series, 'surfaceSlow', 11);
  fast = strncmp (series, 'surfaceFast', 11);
  Z(:, slow) = Z(:, slow) + strength / cosd (41);
  Z(:, fast) = Z(:, fast) + strength / cosd (55);
end

%!test
%! info = struct ('series', {'surfaceSlow', 'surfaceFast', ''});
%! assert (effectOptics ().transform ([1, 2, 3], 1, info), ...
%!         [1 + 1 / cosd(41), 2 + 1 / cosd(55), 3], 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
