% LOADEFFECTS  What the campaign switches on: eight effects of DEM, two of the
% laboratory.
%
% CALL: EFFECTS = loadEffects ()
%
% See also: listEffects, campaignPlan

function effects = loadEffects ()
  effects = {'cohesion', 'tilt', 'opening', 'fill', 'meanSize', ...
             'vibration', 'drag', 'shape', 'gain', 'cameraRoll'};
end
