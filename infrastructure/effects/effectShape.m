% EFFECTSHAPE  Candidate effect: length over width of the grains.
%
% CALL: EFFECT = effectShape (), see describeEffect
function effect = effectShape ()
  given.name = 'shape';
  given.question = 'Are the grains elongated instead of round?';
  given.variables = {'clumpAspect'};
  given.neutral = 1;
  given.limits = [1; 1.6];
  given.unit = '-';
  given.label = 'length over width of the grains';
  given.group = 'grain shape';
  given.source = ['two-sphere clumps of one volume with the ' ...
                  'sphere; LIGGGHTS fix multisphere'];
  given.usually = 'unlikely';
  effect = describeEffect (given);
end
