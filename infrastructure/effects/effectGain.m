% EFFECTGAIN  Candidate effect of the laboratory: relative error of the balance.
%
% CALL: EFFECT = effectGain (), see describeEffect
function effect = effectGain ()
  given.name = 'gain';
  given.question = 'Does the balance show too much or too little?';
  given.neutral = 0;
  given.limits = [-0.05; 0.05];
  given.unit = 'share';
  given.label = 'error of the balance';
  given.group = 'mass';
  given.laboratory = true;
  given.kinds = {'density', 'mass', 'rate'};
  given.transform = @showMore;
  given.source = 'calibration of a balance';
  effect = describeEffect (given);
end

% a factor 1 + strength on everything that is weighed
function Z = showMore (Z, strength, info)
  weighed = ismember ({info.kind}, {'density', 'mass', 'rate'});
  Z(:, weighed) = Z(:, weighed) * (1 + strength);
end

%!test
%! info = struct ('kind', {'mass', 'angle'});
%! assert (effectGain ().transform ([2, 30], 0.05, info), [2.1, 30], 1e-14);

% SPDX-License-Identifier: GPL-3.0-only
