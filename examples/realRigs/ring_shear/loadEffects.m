% LOADEFFECTS  What may have been changed between two series of a ring shear cell.
%
% CALL: EFFECTS = loadEffects ()
%
% The cell is the same in both series; which beads were in it is not told, so
% their properties can have changed. An added lid of 100 Pa is 2.3 % of the
% weight of lid and shaft (2.29 kg on 0.018 m2: 1250 Pa), so twice the lid is
% allowed for.
%
% See also: listEffects, diagnoseGap

function effects = loadEffects ()
  known = {'cohesion', []; 'pullOff', []; 'liquidBridge', []; ...
           'rolling', []; 'shape', []; 'sizeSpread', []; 'restitution', []; ...
           'wallFriction', []; 'lidWeight', [-400; 400]; ...
           'leverArm', []; 'torqueGain', []};
  effects = cell2struct (known, {'name', 'limits'}, 2).';
  [effects.variables, effects.neutral, effects.unit, effects.label, ...
   effects.group] = deal ([]);
  [effects.canChange] = deal ('yes');
  sliding = {'sliding', [0.4; 2.5], {'slidingFactor'}, 1, 'factor', ...
             'the sliding friction of the beads', 'friction', 'yes'};
  effects = [effects, cell2struct(sliding, fieldnames (effects), 2).'];
end
