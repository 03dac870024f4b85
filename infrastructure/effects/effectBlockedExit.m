% EFFECTBLOCKEDEXIT  Candidate effect: share of one exit that is blocked.
%
% CALL: EFFECT = effectBlockedExit (), see describeEffect
function effect = effectBlockedExit ()
  given.name = 'blockedExit';
  given.question = 'Is a part of one exit blocked?';
  given.variables = {'blockedShare'};
  given.neutral = 0;
  given.limits = [0; 0.5];
  given.unit = '-';
  given.label = 'blocked share of an exit';
  given.source = ['a lump, a bridge of grains, or a slide that does not ' ...
                  'open all the way'];
  effect = describeEffect (given);
end
