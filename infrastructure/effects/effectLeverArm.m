% EFFECTLEVERARM  Candidate effect: factor on the load by the arm of a lever.
%
% CALL: EFFECT = effectLeverArm (), see describeEffect
function effect = effectLeverArm ()
  given.name = 'leverArm';
  given.question = ['Is the arm of the lever that loads the lid as long ' ...
                    'as you think?'];
  given.variables = {'leverFactor'};
  given.neutral = 1;
  given.limits = [0.85; 1.15];
  given.unit = 'factor';
  given.label = 'load';
  given.group = 'load';
  given.source = 'a few millimetres of an arm of some centimetres';
  effect = describeEffect (given);
end
