% EFFECTVIBRATION  Candidate effect: peak acceleration over gravity, 60 Hz.
%
% CALL: EFFECT = effectVibration (), see describeEffect
function effect = effectVibration ()
  given.name = 'vibration';
  given.question = 'Does the rig stand on a vibrating floor?';
  given.variables = {'vibrationStrength'};
  given.neutral = 0;
  given.limits = [0; 0.8];
  given.unit = '-';
  given.label = 'vibration (peak acceleration over gravity, 60 Hz)';
  given.saysName = true;
  given.source = 'Janda et al. 2009: vibration below 1 g unclogs and compacts';
  effect = describeEffect (given);
end
