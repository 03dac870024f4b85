% EFFECTLIQUIDBRIDGE  Candidate effect: liquid volume per grain volume.
%
% CALL: EFFECT = effectLiquidBridge (), see describeEffect
function effect = effectLiquidBridge ()
  given.name = 'liquidBridge';
  given.question = ['Is the material moist, with liquid bridges ' ...
                    'between the grains?'];
  given.variables = {'liquidContent'};
  given.neutral = 0;
  given.limits = [0; 0.02];
  given.unit = '-';
  given.label = 'liquid volume per grain volume';
  given.group = 'adhesion';
  given.source = ['Soulie 2006 capillary force, Nase 2001 viscous' ...
                  ' force; LIGGGHTS easo/capillary/viscous; walls' ...
                  ' stay dry'];
  effect = describeEffect (given);
end
