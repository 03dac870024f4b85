% EFFECTDRAG  Candidate effect: inverse relaxation time in the gas.
%
% CALL: EFFECT = effectDrag (), see describeEffect
function effect = effectDrag ()
  given.name = 'drag';
  given.question = 'Are the grains fine or light enough for air to slow them?';
  given.variables = {'dragRate'};
  given.neutral = 0;
  given.limits = [0; 10];
  given.unit = '1/s';
  given.label = 'drag of the gas (1 / relaxation time)';
  given.saysName = true;
  given.source = ['Stokes: 18 eta / (rho d^2), 5 1/s for 0.2 mm ' ...
                  'at 1500 kg/m3 in air'];
  effect = describeEffect (given);
end
