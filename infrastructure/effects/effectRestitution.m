% EFFECTRESTITUTION  Candidate effect: factor on ln (restitution).
%
% CALL: EFFECT = effectRestitution (), see describeEffect
function effect = effectRestitution ()
  given.name = 'restitution';
  given.question = 'Are impacts softer (more damped) or livelier than assumed?';
  given.variables = {'dampingFactor'};
  given.neutral = 1;
  given.limits = [0.3; 4];
  given.unit = 'factor';
  given.label = 'damping of impacts';
  given.source = ['Yan et al. 2015: little influence on angle of ' ...
                  'repose and discharge'];
  given.usually = 'unlikely';
  effect = describeEffect (given);
end
