% LOADEFFECTS  What may have been changed between two series of heaps.
%
% CALL: EFFECTS = loadEffects ()
%
% Nothing is told of grains, plate and funnel: whatever the bench Heap can express.
%
% See also: listEffects, diagnoseGap

function effects = loadEffects ()
  effects = {'cohesion', 'liquidBridge', 'rolling', 'shape', 'sizeSpread', ...
             'meanSize', 'restitution', 'wallFriction', 'fill', 'tilt', 'liftSpeed'};
end
