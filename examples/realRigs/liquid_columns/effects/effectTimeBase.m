% EFFECTTIMEBASE  Candidate effect of the laboratory: a film that runs slow.
%
% CALL: EFFECT = effectTimeBase (), see describeEffect
function effect = effectTimeBase ()
  given.name = 'timeBase';
  given.question = 'Does the camera take as many pictures a second as you think?';
  given.neutral = 0;
  given.limits = [-0.3; 0.3];
  given.unit = '-';
  given.label = 'share of time that the film does not show';
  given.group = 'clock';
  given.laboratory = true;
  given.kinds = {'time'};
  given.transform = @showLater;
  given.source = 'two cameras differ by 11 % in time';
  effect = describeEffect (given);
end

% at the time t of the film 1 + strength of it has passed
function Z = showLater (Z, strength, info)
  relative = info;
  for k = 1:numel (relative)
    relative(k).at = log (info(k).at);
  end
  Z = shiftSeries (Z, strength, relative, 'time');
end

%!test
%! % a front that goes with the logarithm of time; another curve stays
%! info = struct ('series', {'timeA', 'timeA', 'x'}, 'at', {1, e, 1});
%! Z = effectTimeBase ().transform ([2, 5, 7], 0.1, info);
%! assert (Z, [2.3, 5.3, 7], 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
