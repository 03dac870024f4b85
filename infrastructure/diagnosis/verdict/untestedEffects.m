% UNTESTEDEFFECTS  Says of effects without a result why there is none.
%
% CALL: LIST = untestedEffects (NAMES, EFFECTS, STATE)
%
%   NAMES    1 x u cell, effects of which no run gave a result
%   EFFECTS  1 x K struct of newEffect
%   STATE    of newGapState
%   LIST     1 x u struct array: name; runs (of it alone, that have failed; 0:
%            none was made); why (what most of them have said, text)

function list = untestedEffects (names, effects, state)
  list = struct ('name', {}, 'runs', {}, 'why', {});
  lost = state.budget.lost;
  data = state.data;
  E = vertcat (zeros (0, columns (data.E)), lost.E);
  for name = names
    only = @(E) alone (strengthOfValues (effects, E), ...
                       strcmp ({effects.name}, name{1}));
    [texts, ~, at] = unique ({lost(only (E)).message});
    why = '';
    if ~isempty (texts)
      % what most of them ended with
      why = texts{mode(at)};
    end
    isFailed = only (data.E) & any (isnan (data.Z) & ~isna (data.Z), 2);
    list(end + 1) = struct ('name', name{1}, 'runs', sum (isFailed), ...
                            'why', why);
  end
end

% Rows of PHI in which the effect IS acts, and no other.
function yes = alone (phi, is)
  acts = abs (phi) > 1e-9;
  yes = any (acts(:, is), 2) & ~any (acts(:, ~is), 2);
end

%!test
%! effects = arrayfun (@(name) newEffect (struct ('name', name, 'variables', ...
%!                                                {{name}}, 'neutral', 0, ...
%!                                                'limits', [0; 2]), 1), 'ab');
%! state.data = struct ('E', [0, 0; 2, 0; 1, 0; 1, 1; 0, 1], ...
%!                      'Z', [[1; NaN; NaN; NaN; 3], NA(5, 1)]);
%! state.budget.lost = struct ('E', {[2, 0], [1, 0], [1, 0], [1, 1]}, ...
%!                             'message', {'y', 'x', 'x', 'z'});
%! list = untestedEffects ({'a', 'b'}, effects, state);
%! assert ({list.name, list.runs, list.why}, {'a', 'b', 2, 0, 'x', ''});
%! state.budget.lost(:) = [];
%! assert (untestedEffects ({'a'}, effects, state).why, '');
%! assert (isempty (untestedEffects (cell (1, 0), effects, state)));

% SPDX-License-Identifier: GPL-3.0-only
