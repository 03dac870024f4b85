% EFFECTOPENING  Candidate effect: factor on the opening.
%
% CALL: EFFECT = effectOpening (), see describeEffect
function effect = effectOpening ()
  given.name = 'opening';
  given.question = 'Is the opening as wide as the drawing says?';
  given.variables = {'openingFactor'};
  given.neutral = 1;
  given.limits = [0.92; 1.08];
  given.unit = 'factor';
  given.label = 'opening';
  given.saysName = true;
  given.source = 'Beverloo 1961';
  effect = describeEffect (given);
end
