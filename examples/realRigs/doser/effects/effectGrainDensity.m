% EFFECTGRAINDENSITY  Candidate effect of the laboratory: density of the grains.
%
% CALL: EFFECT = effectGrainDensity (), see describeEffect
function effect = effectGrainDensity ()
  given.name = 'grainDensity';
  given.question = 'Are the grains as dense as before?';
  given.neutral = 0;
  given.limits = [-0.2; 0.2];
  given.unit = 'share';
  given.label = 'change of the density of the grains';
  given.group = 'mass';
  given.laboratory = true;
  given.kinds = {'logMass'};
  given.transform = @showMore;
  given.source = 'another batch';
  effect = describeEffect (given);
end

% about 1 + strength times the mass; ratios stay. Linear, as effects must be
function Z = showMore (Z, strength, info)
  isMass = strcmp ({info.kind}, 'logMass');
  Z(:, isMass) = Z(:, isMass) + strength;
end

%!test
%! info = struct ('kind', {'logMass', 'logRatio'});
%! assert (effectGrainDensity ().transform ([-1, 2], 0.1, info), [-0.9, 2], 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
