% LOADEFFECTS  What might be missing in the model: the user's candidates.
%
% CALL: EFFECTS = loadEffects ()
%
% See also: listEffects, diagnoseGap

function effects = loadEffects ()
  effects = {'cohesion', 'liquidBridge', 'wallAdhesion', 'sizeSpread', ...
             'meanSize', 'shape', 'restitution', 'tilt', 'vibration', ...
             'drag', 'gain', 'cameraRoll'};
end
