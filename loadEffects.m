% LOADEFFECTS  The effects that may cause the gap: the user's candidates.
%
% CALL: EFFECTS = loadEffects ()
%
% EFFECTS  1 x e struct array, or [] for none. An entry is
%            a name of the library alone (listEffects shows them all):
%              effects(1).name = 'cohesion';
%            a name of the library with your own limits, weakest and strongest
%            plausible value:
%              effects(2).name = 'tilt';  effects(2).limits = [0; 1];
%            any variable that the data.head of your model declares:
%              effects(3).name = 'lid';   effects(3).variables = {'lidMass'};
%              effects(3).neutral = 0;    effects(3).limits = [0; 0.5];
%          optional fields: label, unit, group (effects that look alike)
%
% A file effects/effect<Name>.m in the case's folder adds to the library.
% docs/effects.md lists the library, and where its signs were measured.
%
% See also: listEffects, resolveEffects, diagnoseGap
function effects = loadEffects ()
  effects = [];
end

%!assert (isempty (loadEffects ()))
