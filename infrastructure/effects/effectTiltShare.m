% EFFECTTILTSHARE  Candidate effect: share of a commanded tilt that is reached.
%
% CALL: EFFECT = effectTiltShare (), see describeEffect
function effect = effectTiltShare ()
  given.name = 'tiltShare';
  given.question = ['Does a rig that is to be tilted reach the angle ' ...
                    'that it is told?'];
  given.variables = {'tiltShare'};
  given.neutral = 1;
  given.limits = [0.8; 1.2];
  given.unit = '-';
  given.label = 'share of the commanded tilt';
  given.group = 'alignment';
  given.source = 'play of a hinge, a scale that is read askew';
  effect = describeEffect (given);
end
