% VARIABLESOFEFFECTS  Names of the LIGGGHTS variables of all effects of a list.
%
% CALL: NAMES = variablesOfEffects (EFFECTS)
%
%   EFFECTS  struct array of resolveEffects; may be empty
%   NAMES    1 x v cellstr, in the order of the effects; an effect of the
%            laboratory has none
%
% See also: resolveEffects, newCase, withEffects

function names = variablesOfEffects (effects)
  names = {};
  for k = 1:numel (effects)
    names = [names, effects(k).variables(:)'];
  end
end

%!assert (variablesOfEffects ([]), {})
%!test
%! effects = resolveEffects ({'tilt', 'gain', 'cohesion'});
%! assert (variablesOfEffects (effects), {'tiltAngle', 'cohesionPP'});
