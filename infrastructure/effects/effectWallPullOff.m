% EFFECTWALLPULLOFF  Candidate effect: attraction of grains and walls.
%
% CALL: EFFECT = effectWallPullOff (), see describeEffect
function effect = effectWallPullOff ()
  given.name = 'wallPullOff';
  given.question = ['Do grains stick to the walls so that a force is ' ...
                    'needed to part them?'];
  given.variables = {'adhesionPW'};
  given.neutral = 0;
  given.limits = [0; 0.2];
  given.unit = 'J/m2';
  given.label = 'work of adhesion between grains and walls';
  given.group = 'adhesion';
  given.source = 'Derjaguin, Muller, Toporov 1975: 2 pi R w';
  effect = describeEffect (given);
end
