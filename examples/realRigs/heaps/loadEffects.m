% LOADEFFECTS  What may have been changed between two series of heaps.
%
% CALL: EFFECTS = loadEffects ()
%
% Nothing is told of grains, plate and funnel: whatever the runs of the bench have.
%
% See also: listEffects, diagnoseGap

function effects = loadEffects ()
  effects = {'cohesion', 'liquidBridge', 'wallAdhesion', 'shape', 'sizeSpread', ...
             'meanSize', 'restitution', 'tilt', 'vibration', 'gain', 'cameraRoll'};
end
