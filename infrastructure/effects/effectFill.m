% EFFECTFILL  Candidate effect: factor on the filled mass.
%
% CALL: EFFECT = effectFill (), see describeEffect
function effect = effectFill ()
  given.name = 'fill';
  given.question = 'Was as much material filled in as the protocol says?';
  given.variables = {'fillFactor'};
  given.neutral = 1;
  given.limits = [0.85; 1.15];
  given.unit = 'factor';
  given.label = 'filled mass';
  given.saysName = true;
  given.source = 'weighing and levelling errors of hand filling';
  effect = describeEffect (given);
end
