% EFFECTROLLING  Candidate effect: added rolling friction.
%
% CALL: EFFECT = effectRolling (), see describeEffect
function effect = effectRolling ()
  given.name = 'rolling';
  given.question = ['Do the grains resist rolling more than the ' ...
                    'model says (flat faces, dents)?'];
  given.variables = {'rollingAdded'};
  given.neutral = 0;
  given.limits = [0; 0.4];
  given.unit = '-';
  given.label = 'added rolling friction';
  given.group = 'grain shape';
  given.source = ['Wensrich and Katterfeld 2012 (rolling friction' ...
                  ' as a stand-in for shape)'];
  given.usually = 'unlikely';
  effect = describeEffect (given);
end
