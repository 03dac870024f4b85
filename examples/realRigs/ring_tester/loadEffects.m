% LOADEFFECTS  What may have been changed between two series of a ring shear tester.
%
% CALL: EFFECTS = loadEffects ()
%
% Which material was in it is told of series 1 alone (glass beads), so all of the other
% one's properties can differ.
%
% See also: listEffects, diagnoseGap

function effects = loadEffects ()
  known = {'cohesion', []; 'liquidBridge', []; 'rolling', []; 'shape', []; ...
           'sizeSpread', []; 'leverArm', []};
  effects = cell2struct (known, {'name', 'limits'}, 2).';
  [effects.variables, effects.neutral, effects.unit, effects.label, ...
   effects.group] = deal ([]);
  [effects.canChange] = deal ('yes');
  sliding = {'sliding', [0.4; 2.5], {'slidingFactor'}, 1, 'factor', ...
             'the sliding friction of the beads', 'friction', 'yes'};
  effects = [effects, cell2struct(sliding, fieldnames (effects), 2).'];
end
