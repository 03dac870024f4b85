% EFFECTPULLOFF  Candidate effect: attraction of grains, with a pull-off force.
%
% CALL: EFFECT = effectPullOff (), see describeEffect
function effect = effectPullOff ()
  given.name = 'pullOff';
  given.question = ['Do grains stick to each other so that a force is ' ...
                    'needed to part them?'];
  given.variables = {'adhesionPP'};
  given.neutral = 0;
  given.limits = [0; 0.2];
  given.unit = 'J/m2';
  given.label = 'work of adhesion between grains';
  given.group = 'adhesion';
  given.source = ['Derjaguin, Muller, Toporov 1975: 2 pi R* w; 2 x 0.072 ' ...
                  'J/m2 makes the force of a bridge of water'];
  effect = describeEffect (given);
end
