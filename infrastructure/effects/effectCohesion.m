% EFFECTCOHESION  Candidate effect: cohesion energy density between grains.
%
% CALL: EFFECT = effectCohesion (), see describeEffect
function effect = effectCohesion ()
  given.name = 'cohesion';
  given.question = 'Do dry grains stick to each other?';
  given.variables = {'cohesionPP'};
  given.neutral = 0;
  given.limits = [0; 6e4];
  given.unit = 'J/m3';
  given.label = 'cohesion energy density between grains';
  given.saysName = true;
  given.group = 'adhesion';
  given.source = 'simplified JKR: attraction = energy density x contact area';
  effect = describeEffect (given);
end
