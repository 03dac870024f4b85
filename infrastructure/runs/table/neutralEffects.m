% NEUTRALEFFECTS  Values of a plain run: the last level, all effects off.
%
% CALL: [E, ALONE] = neutralEffects (CASE)
%
%   E     1 x v, columns as CASE.effectVars; effects of the laboratory act on
%         results and have no variables
%   ALONE  those of the effects alone, without the levels

function [E, alone] = neutralEffects (Case)
  E = zeros (1, 0);
  for coarse = Case.coarse
    E = [E, coarse.levels(end)];
  end
  v = columns (E);
  for k = 1:numel (Case.effects)
    if ~givenField (Case.effects(k), 'laboratory', false)
      E = [E, Case.effects(k).neutral(:)'];
    end
  end
  alone = E(v + 1:end);
end

%!function E = of (effects, coarse)
%!  E = neutralEffects (struct ('effects', {effects}, 'coarse', coarse));
%!endfunction
%!assert (of ([], []), zeros (1, 0))
%!assert (of (struct ('neutral', {1, [2, 3]}), []), [1, 2, 3])
%!assert (of (resolveEffects ({'gain', 'shape', 'cameraRoll'}), []), 1)
%!assert (of (struct ('neutral', 5), struct ('levels', [3, 2])), [2, 5])
%!test
%! Case = struct ('effects', struct ('neutral', 5), 'coarse', ...
%!                struct ('levels', [3, 2]));
%! [~, alone] = neutralEffects (Case);
%! assert (alone, 5);

% SPDX-License-Identifier: GPL-3.0-only
