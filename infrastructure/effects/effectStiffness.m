% EFFECTSTIFFNESS  Candidate effect: factor on Young's modulus.
%
% CALL: EFFECT = effectStiffness (), see describeEffect
function effect = effectStiffness ()
  given.name = 'stiffness';
  given.question = 'Are the grains stiffer or softer than in the model?';
  given.variables = {'stiffnessFactor'};
  given.neutral = 1;
  given.limits = [0.4; 4];
  given.unit = 'factor';
  given.label = 'Young''s modulus';
  given.source = ['Yan et al. 2015; moduli are lowered in DEM to ' ...
                  'lengthen the time step'];
  given.usually = 'unlikely';
  effect = describeEffect (given);
end
