% EFFECTGRAVITY  Candidate effect: factor on gravity.
%
% CALL: EFFECT = effectGravity (), see describeEffect
function effect = effectGravity ()
  given.name = 'gravity';
  given.question = ['Is the weight of the grains another one, as in a ' ...
                    'centrifuge or a lift?'];
  given.variables = {'gravityFactor'};
  given.neutral = 1;
  given.limits = [0.8; 1.2];
  given.unit = 'factor';
  given.label = 'gravity';
  given.saysName = true;
  given.source = ['the speed of a centrifuge is known to a few per cent; ' ...
                  'give limits of your own for another planet'];
  given.usually = 'unlikely';
  effect = describeEffect (given);
end
