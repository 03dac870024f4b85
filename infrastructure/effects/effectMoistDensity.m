% EFFECTMOISTDENSITY  Candidate effect: factor on grain density.
%
% CALL: EFFECT = effectMoistDensity (), see describeEffect
function effect = effectMoistDensity ()
  given.name = 'moistDensity';
  given.question = 'Have the grains taken up water and become heavier?';
  given.variables = {'densityFactor'};
  given.neutral = 1;
  given.limits = [0.95; 1.2];
  given.unit = 'factor';
  given.label = 'grain density';
  given.group = 'mass';
  given.source = ['wood and grain take up 5 to 20 % of their mass' ...
                  ' from moist air'];
  effect = describeEffect (given);
end
