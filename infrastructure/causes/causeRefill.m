% CAUSEREFILL  What a person may ask for: a refilled or half-empty machine.
%
% CALL: CAUSE = causeRefill (), see describeCause
function cause = causeRefill ()
  given.name = 'refill';
  given.label = 'another filling';
  given.question = 'Has the machine been refilled, or is it half empty?';
  given.members = { ...
                   {'fill'}, '', 0, 0.7};
  given.source = 'what was filled in is seldom weighed';
  cause = describeCause (given);
end
