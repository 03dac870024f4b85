% EFFECTSPEEDERROR  Candidate effect of the laboratory: error of the speed.
%
% CALL: EFFECT = effectSpeedError (), see describeEffect
function effect = effectSpeedError ()
  given.name = 'speedError';
  given.question = 'Does the drum turn as fast as its display says?';
  given.neutral = 0;
  given.limits = [-0.25; 0.25];
  given.unit = 'share';
  given.label = 'error of the speed';
  given.group = 'speed';
  given.laboratory = true;
  given.kinds = {'speed'};
  given.transform = @turnFaster;
  given.source = 'uncalibrated drive';
  effect = describeEffect (given);
end

% curves over speed are read at speed x (1 + strength)
function Z = turnFaster (Z, strength, info)
  relative = info;
  for k = 1:numel (relative)
    relative(k).at = log (info(k).at);
  end
  Z = shiftSeries (Z, strength, relative, 'speed');
end

%!test % 20 degrees at 1 rad/s, 30 degrees at e rad/s: 10 degrees a unit of log
%! info = struct ('kind', 'angle', 'series', 'speedSlope', ...
%!                'at', {1, exp(1)});
%! z = effectSpeedError ().transform ([20, 30], 0.1, info);
%! assert (z, [21, 31], 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
