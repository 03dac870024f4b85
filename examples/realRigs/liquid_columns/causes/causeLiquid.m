% CAUSELIQUID  What a person may ask for: another liquid.
%
% CALL: CAUSE = causeLiquid (), see describeCause
function cause = causeLiquid ()
  given.name = 'liquid';
  given.label = 'another liquid';
  given.question = 'Is the liquid another one, or has something got into it?';
  given.members = { ...
                   {'drag'}, '', 0.5, 0.4; ...
                   {'buoyancy'}, '', 0, 0.5; ...
                   {'sliding'}, '', 0, 0.3; ...
                   {'liquidBridge'}, '', 0, 0.3; ...
                   {'restitution'}, '', 0.2, 0.3};
  given.source = 'viscosity, density, lubrication, surface tension, damping';
  cause = describeCause (given);
end

% SPDX-License-Identifier: GPL-3.0-only
