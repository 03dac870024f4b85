% INUNITS  Expresses the measurements of a diagnosis in other units.
%
% CALL: PROBLEM = inUnits (PROBLEM, UNIT)
%
%   PROBLEM     struct of newProblem
%   UNIT        1 x T, what one new unit of each target is in the old one
%   PROBLEM     the same in the new units

function problem = inUnits (problem, unit)
  for field = problemFields ()
    if field.hasUnit
      problem.(field.name) = problem.(field.name) ./ unit;
    end
  end
  if ~isempty (problem.reference)
    for name = {'value', 'sd', 'shared'}
      problem.reference.(name{1}) = problem.reference.(name{1}) ./ unit;
    end
    problem.reference.together = problem.reference.together ./ (unit' * unit);
  end
  if ~isempty (problem.covariance)
    problem.covariance = problem.covariance ./ (unit' * unit);
  end
  for k = 1:numel (problem.effects)
    e = problem.effects(k);
    problem.effects(k).offset = e.offset ./ unit;
    problem.effects(k).offsetSd = e.offsetSd ./ unit;
    problem.effects(k).matrix = (unit' .* e.matrix) ./ unit;
  end
end

%!test
%! % an effect of the laboratory does the same in the other units
%! effect = struct ('name', 'e', 'laboratory', true, 'offset', [1, 2], ...
%!                  'matrix', [0.1, 2; 0, 0.3]);
%! given = struct ('value', [8, 9], 'sd', [1, 1], 'limits', [0; 1], ...
%!                 'bench', [1, 1], 'covariance', [4, 1; 1, 4], ...
%!                 'shared', [0.5, 0]);
%! given.effects = effect;
%! old = newProblem (given);
%! unit = [1e-3, 50];
%! new = inUnits (old, unit);
%! m = [5, 7];
%! e = new.effects;
%! moved = m ./ unit + e.offset + (m ./ unit) * e.matrix;
%! assert (moved .* unit, m + effect.offset + m * effect.matrix, 1e-12);
%! assert (new.shared, [500, 0], 1e-9);
%! assert (new.covariance .* (unit' * unit), given.covariance, 1e-12);
%! assert (inUnits (new, 1 ./ unit).value, old.value, 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
