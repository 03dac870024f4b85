% EFFECTLIFTSPEED  Candidate effect: factor on the lifting speed of a tube.
%
% CALL: EFFECT = effectLiftSpeed (), see describeEffect
function effect = effectLiftSpeed ()
  given.name = 'liftSpeed';
  given.question = ['Is the tube or the gate lifted as fast as the ' ...
                    'drawing says?'];
  given.variables = {'liftFactor'};
  given.neutral = 1;
  given.limits = [0.3; 3];
  given.unit = 'factor';
  given.label = 'lifting speed';
  given.source = 'a hand lifts several times faster or slower than it is told';
  effect = describeEffect (given);
end
