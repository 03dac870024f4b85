% EFFECTWALLFRICTION  Candidate effect: factor on wall friction.
%
% CALL: EFFECT = effectWallFriction (), see describeEffect
function effect = effectWallFriction ()
  given.name = 'wallFriction';
  given.question = ['Is the wall smoother or rougher than the one ' ...
                    'whose friction was measured?'];
  given.variables = {'wallFrictionFactor'};
  given.neutral = 1;
  given.limits = [0.1; 1.7];
  given.unit = 'factor';
  given.label = 'wall friction';
  given.group = 'wall';
  given.source = ['friction of one plastic on polished and rough ' ...
                  'steel differs by a factor of 2 to 3'];
  effect = describeEffect (given);
end
