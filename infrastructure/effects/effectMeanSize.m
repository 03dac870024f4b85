% EFFECTMEANSIZE  Candidate effect: factor on grain size.
%
% CALL: EFFECT = effectMeanSize (), see describeEffect
function effect = effectMeanSize ()
  given.name = 'meanSize';
  given.question = 'Are the grains larger or smaller than assumed?';
  given.variables = {'sizeFactor'};
  given.neutral = 1;
  given.limits = [0.85; 1.2];
  given.unit = 'factor';
  given.label = 'grain size';
  given.group = 'size';
  given.source = 'Beverloo 1961: the discharge feels (D - k d)';
  given.usually = 'unlikely';
  effect = describeEffect (given);
end
