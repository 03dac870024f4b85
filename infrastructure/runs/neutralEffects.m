% NEUTRALEFFECTS  The effect values that switch all effects off.
%
% CALL: E = neutralEffects (CASE)
%
%   CASE  see newCase
%   E     1 x v, columns as CASE.effectVars; effects of the laboratory act on
%         results and have no variables
%
% See also: newJobs

function E = neutralEffects (Case)
  E = zeros (1, 0);
  for k = 1:numel (Case.effects)
    effect = Case.effects(k);
    if ~(isfield (effect, 'laboratory') && effect.laboratory)
      E = [E, effect.neutral(:)'];
    end
  end
end

%!assert (neutralEffects (struct ('effects', [])), zeros (1, 0))
%!test
%! effects = struct ('neutral', {1, [2, 3]});
%! assert (neutralEffects (struct ('effects', effects)), [1, 2, 3]);
%!assert (neutralEffects (struct ('effects', ...
%!        resolveEffects ({'gain', 'shape', 'cameraRoll'}))), 1)
