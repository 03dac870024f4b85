% CAUSECAMERAS  What a person may ask for: the cameras.
%
% CALL: CAUSE = causeCameras (), see describeCause
function cause = causeCameras ()
  given.name = 'cameras';
  given.label = 'the cameras';
  given.question = 'Have the cameras been moved, or set in another way?';
  given.members = { ...
                   {'scale'}, '', 0, 0.6; ...
                   {'timeBase'}, '', 0, 0.6; ...
                   {'timeOffset'}, '', 0, 0.6};
  given.oneOf = true;
  given.source = 'two cameras differ by 6 % in radius, by 11 % in time';
  cause = describeCause (given);
end

% SPDX-License-Identifier: GPL-3.0-only
