% EFFECTSCALE  Candidate effect of the laboratory: a scale of the pictures.
%
% CALL: EFFECT = effectScale (), see describeEffect
function effect = effectScale ()
  given.name = 'scale';
  given.question = 'Is a millimetre of the picture a millimetre of the plate?';
  given.neutral = 0;
  given.limits = [-0.15; 0.15];
  given.unit = 'share';
  given.label = 'error of the scale of the cameras';
  given.group = 'camera';
  given.laboratory = true;
  given.kinds = {'length'};
  given.transform = @showMore;
  given.source = 'two cameras differ by 6 % in radius';
  effect = describeEffect (given);
end

function Z = showMore (Z, strength, info)
  seen = strcmp ({info.kind}, 'length');
  Z(:, seen) = Z(:, seen) * (1 + strength);
end

%!test
%! info = struct ('kind', {'length', 'angle'});
%! assert (effectScale ().transform ([0.1, 30], 0.05, info), [0.105, 30], 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
