% NEUTRALEFFECTS  Values of a plain run: the last level, all effects off.
%
% CALL: E = neutralEffects (CASE)
%
%   E     1 x v, columns as CASE.effectVars; effects of the laboratory act on
%         results and have no variables

function E = neutralEffects (Case)
  E = zeros (1, 0);
  for coarse = Case.coarse
    E = [E, coarse.levels(end)];
  end
  for k = 1:numel (Case.effects)
    if ~givenField (Case.effects(k), 'laboratory', false)
      E = [E, Case.effects(k).neutral(:)'];
    end
  end
end

%!function E = of (effects, coarse)
%!  E = neutralEffects (struct ('effects', {effects}, 'coarse', coarse));
%!endfunction
%!assert (of ([], []), zeros (1, 0))
%!assert (of (struct ('neutral', {1, [2, 3]}), []), [1, 2, 3])
%!assert (of (resolveEffects ({'gain', 'shape', 'cameraRoll'}), []), 1)
%!assert (of (struct ('neutral', 5), struct ('levels', [3, 2])), [2, 5])
