% EFFECTTILT  Candidate effect: tilt of the rig.
%
% CALL: EFFECT = effectTilt (), see describeEffect
function effect = effectTilt ()
  given.name = 'tilt';
  given.question = 'Does the rig stand level?';
  given.variables = {'tiltAngle'};
  given.neutral = 0;
  given.limits = [-2; 2];
  given.unit = 'deg';
  given.label = 'tilt of the rig';
  given.saysName = true;
  given.group = 'alignment';
  given.source = 'geometry; the levelling of a rig is good to a degree or two';
  effect = describeEffect (given);
end
