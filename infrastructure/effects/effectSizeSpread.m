% EFFECTSIZESPREAD  Candidate effect: relative spread of the grain size.
%
% CALL: EFFECT = effectSizeSpread (), see describeEffect
function effect = effectSizeSpread ()
  given.name = 'sizeSpread';
  given.question = 'Do the grains differ in size?';
  given.variables = {'sizeSpread'};
  given.neutral = 0;
  given.limits = [0; 0.2];
  given.unit = '-';
  given.label = 'spread of the grain size (standard deviation over mean)';
  given.group = 'size';
  given.source = 'three sizes by number 1:2:1, Sauter diameter kept';
  given.usually = 'unlikely';
  effect = describeEffect (given);
end
