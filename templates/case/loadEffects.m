% LOADEFFECTS  Candidate effects for decalioc diagnose.
%
% CALL: EFFECTS = loadEffects ()
%
% What may be missing in the model @MODEL@, should it miss a measurement. Names
% of the library (docs/effects.md), or four fields of your own.

function effects = loadEffects ()
  effects = {'cohesion', 'shape', 'sizeSpread', 'tilt', 'fill'};
end
