% EFFECTBALANCE  Candidate effect of the laboratory: relative error of the balance.
%
% CALL: EFFECT = effectBalance (), see describeEffect
function effect = effectBalance ()
  given.name = 'balance';
  given.question = 'Does the balance show what lies on it?';
  given.neutral = 0;
  given.limits = [-0.3; 0.3];
  given.unit = 'share';
  given.label = 'error of the balance';
  given.group = 'mass';
  given.laboratory = true;
  given.kinds = {'logMass'};
  given.transform = @showMore;
  given.source = 'a balance that stands askew, or touches something';
  effect = describeEffect (given);
end

% about 1 + strength times the mass; ratios stay. Linear, as effects must be
function Z = showMore (Z, strength, info)
  isMass = strcmp ({info.kind}, 'logMass');
  Z(:, isMass) = Z(:, isMass) + strength;
end

%!test
%! info = struct ('kind', {'logMass', 'logRatio'});
%! assert (effectBalance ().transform ([-1, 2], 0.1, info), [-0.9, 2], 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
