% EFFECTTORQUEGAIN  Candidate effect of the laboratory: the torque reads too high.
%
% CALL: EFFECT = effectTorqueGain (), see describeEffect
function effect = effectTorqueGain ()
  given.name = 'torqueGain';
  given.question = 'Is the arm as long, and the force gauge as right, as you think?';
  given.neutral = 0;
  given.limits = [-0.25; 0.25];
  given.unit = 'share';
  given.label = 'error of the torque';
  given.group = 'instrument';
  given.laboratory = true;
  given.kinds = {'stress'};
  given.transform = @showMore;
  given.source = 'a home-made cell: the force acts on an arm that is measured by hand';
  effect = describeEffect (given);
end

% a factor 1 + strength on every shear stress
function Z = showMore (Z, strength, info)
  sheared = strcmp ({info.kind}, 'stress');
  Z(:, sheared) = Z(:, sheared) * (1 + strength);
end

%!test
%! info = struct ('kind', {'stress', 'angle'});
%! assert (effectTorqueGain ().transform ([200, 30], 0.05, info), [210, 30], 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
