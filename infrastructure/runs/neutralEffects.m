% NEUTRALEFFECTS  The effect values that switch all effects off.
%
% CALL: E = neutralEffects (CASE)
%
%   CASE  see newCase
%   E     1 x v, columns as CASE.effectVars
%
% See also: newJobs

function E = neutralEffects (Case)
  E = zeros (1, 0);
  for k = 1:numel (Case.effects)
    E = [E, Case.effects(k).neutral(:)'];
  end
end

%!assert (neutralEffects (struct ('effects', [])), zeros (1, 0))
%!assert (neutralEffects (struct ('effects', struct ('neutral', {1, [2, 3]}))), ...
%!        [1, 2, 3])
