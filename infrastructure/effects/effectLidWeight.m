% EFFECTLIDWEIGHT  Candidate effect: load on the bed beside the one that is set.
%
% CALL: EFFECT = effectLidWeight (), see describeEffect
function effect = effectLidWeight ()
  given.name = 'lidWeight';
  given.question = 'Do lid, hanger or a spring add to the load that is set?';
  given.variables = {'lidLoad'};
  given.neutral = 0;
  given.limits = [-100; 100];
  given.unit = 'Pa';
  given.label = 'load in addition to the one that is set';
  given.group = 'load';
  given.source = ['a lid of 5 mm of steel weighs 390 Pa; it is often ' ...
                  'weighed, and forgotten or counted twice'];
  effect = describeEffect (given);
end
