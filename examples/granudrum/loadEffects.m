% LOADEFFECTS  What the null model of the GranuDrum may leave out.
%
% CALL: EFFECTS = loadEffects ()
%
% The null model: spheres of one size, Hertz, no cohesion, walls as rough as the
% grains. How much was filled in is a parameter, drumSolid, and so no effect.
%
% Cohesion ranges up to 1.5e4 J/m3: with a Young's modulus of 1 MPa the grains
% hold each other by about four times their weight then, F = 16 / 3 pi^3 k^3
% R^2 / E^2 of the simplified JKR law on Hertz contacts.
%
% See also: effectOptics, listEffects, diagnoseGap

function effects = loadEffects ()
  effects = cell2struct ({'wallFriction'; 'cohesion'; 'liquidBridge'; ...
                          'shape'; 'sizeSpread'; 'restitution'; 'drag'; ...
                          'windowFriction'; 'optics'; 'cameraRoll'}, ...
                         'name', 2).';
  effects(2).limits = [0; 1.5e4];
  effects(8).variables = {'windowFrictionFactor'};
  effects(8).neutral = 1;
  effects(8).limits = [0.1; 1.7];
  effects(8).unit = 'factor';
  effects(8).label = 'the friction of the end windows';
  effects(8).group = 'wall';
end
