% LOADEFFECTS  What may have been changed between two series of a ring shear tester.
%
% CALL: EFFECTS = loadEffects ()
%
% Only of series 1 is the material told (glass beads): whatever the runs of the bench have.
%
% See also: listEffects, diagnoseGap

function effects = loadEffects ()
  effects = {'cohesion', 'liquidBridge', 'wallAdhesion', 'shape', 'sizeSpread', ...
             'meanSize', 'restitution', 'vibration', 'gain'};
end
