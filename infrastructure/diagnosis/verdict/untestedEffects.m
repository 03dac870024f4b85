% UNTESTEDEFFECTS  Says of effects why they have no result, or none where they are strong.
%
% CALL: LIST = untestedEffects (NAMES, EFFECTS, STATE)
%
%   NAMES    1 x u cell, effects of which no run gave a result
%   EFFECTS  1 x K struct of newEffect
%   STATE    of newGapState
%   LIST     1 x u struct array: name; runs (of it alone, that have failed; 0:
%            none was made); why (what most of them have said, text); beyond (NaN); then
%            those of which two runs at least have failed that were stronger than each
%            that has a result: beyond is the strength of that one

function list = untestedEffects (names, effects, state)
  list = struct ('name', {}, 'runs', {}, 'why', {}, 'beyond', {});
  if isempty (effects)                   % it may be [], without names
    return
  end
  data = state.data;
  phi = strengthOfValues (effects, data.E);
  isFailed = any (isnan (data.Z) & ~isna (data.Z), 2);
  for name = names
    runs = sum (isFailed & alone (phi, strcmp ({effects.name}, name{1})));
    list(end + 1) = struct ('name', name{1}, 'runs', runs, 'why', ...
                            whyOf (effects, state, name{1}), 'beyond', NaN);
  end
  isLost = isFailed & all (isnan (data.Z), 2);      % what has one result tells of it
  for k = find (~ismember ({effects.name}, names))
    is = (1:numel (effects)) == k;
    for sign_ = [-1, 1]
      own = sign_ * phi(:, k) .* alone (phi, is);
      reached = max ([own(~isLost); 0]);
      runs = sum (own > reached & isLost);
      if runs >= 2 && reached > 0
        list(end + 1) = struct ('name', effects(k).name, 'runs', runs, 'why', ...
                                whyOf (effects, state, effects(k).name), 'beyond', ...
                                sign_ * reached);
      end
    end
  end
end

% What most runs of it ended with; '' where there are none.
function why = whyOf (effects, state, name)
  why = '';
  lost = state.budget.lost;
  E = vertcat (zeros (0, columns (state.data.E)), lost.E);
  [texts, ~, at] = unique ({lost(alone (strengthOfValues (effects, E), ...
                                        strcmp ({effects.name}, name))).message});
  if ~isempty (texts)
    why = texts{mode(at)};
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
%! none = setfield (state, 'data', 'E', zeros (5, 0));
%! assert (isempty (untestedEffects (cell (1, 0), [], none)));
%! % it has results, but its two strongest runs failed; one alone may be chance
%! state.data = struct ('E', [0, 0; 0.5, 0; 0.8, 0; 1.6, 0; 2, 0; 0, 1; 0, 2], ...
%!                      'Z', [1; 2; 3; NaN; NaN; 4; NaN]);
%! list = untestedEffects (cell (1, 0), effects, state);
%! assert ({list.name, list.runs}, {'a', 2});
%! assert (list.beyond, strengthOfValues (effects, [0.8, 0])(1), 1e-12);
%! % one of two results is there
%! state.data.Z = [state.data.Z, ones(7, 1)];
%! assert (isempty (untestedEffects (cell (1, 0), effects, state)));

% SPDX-License-Identifier: GPL-3.0-only
