% EFFECTWALLADHESION  Candidate effect: cohesion energy density at the walls.
%
% CALL: EFFECT = effectWallAdhesion (), see describeEffect
function effect = effectWallAdhesion ()
  given.name = 'wallAdhesion';
  given.question = 'Does the material stick to the walls?';
  given.variables = {'cohesionPW'};
  given.neutral = 0;
  given.limits = [0; 6e4];
  given.unit = 'J/m3';
  given.label = 'cohesion energy density at the walls';
  given.group = 'adhesion';
  given.source = 'simplified JKR on wall contacts only';
  effect = describeEffect (given);
end
