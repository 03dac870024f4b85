% EFFECTBUOYANCY  Candidate effect: share of the weight that a fluid bears.
%
% CALL: EFFECT = effectBuoyancy (), see describeEffect
function effect = effectBuoyancy ()
  given.name = 'buoyancy';
  given.question = ['Are the grains under a liquid that bears a part of ' ...
                    'their weight?'];
  given.variables = {'buoyancyShare'};
  given.neutral = 0;
  given.limits = [0; 0.6];
  given.unit = '-';
  given.label = 'share of the weight that a fluid bears';
  given.source = ['Archimedes: density of the fluid / density of the ' ...
                  'grains, 0.4 for glass in water; its drag is the ' ...
                  'effect drag'];
  effect = describeEffect (given);
end
