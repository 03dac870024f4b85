% OFTARGETS  The problem of some of its targets.
%
% CALL: PROBLEM = ofTargets (PROBLEM, KEPT)
%
%   PROBLEM  struct of newProblem; what follows from other fields (used, kept
%            ...) is still that of all, see newProblem
%   KEPT     1 x T', numbers of the targets that are left

function problem = ofTargets (problem, kept)
  for field = problemFields ()
    if strcmp (field.count, 'T')
      problem.(field.name) = problem.(field.name)(kept);
    end
  end
  if ~isempty (problem.covariance)
    problem.covariance = problem.covariance(kept, kept);
  end
  if ~isempty (givenField (problem, 'coarse', []))
    problem.coarse.column = problem.coarse.column(kept);
  end
  if ~isempty (problem.reference)
    for name = {'value', 'sd', 'trials', 'scatter', 'shared', 'freedom', ...
                'commonFreedom', 'sessionFreedom'}
      problem.reference.(name{1}) = problem.reference.(name{1})(kept);
    end
    problem.reference.together = problem.reference.together(kept, kept);
  end
  for k = 1:numel (problem.effects)
    e = problem.effects(k);
    problem.effects(k).offset = e.offset(kept);
    problem.effects(k).offsetSd = e.offsetSd(kept);
    problem.effects(k).matrix = e.matrix(kept, kept);
  end
end

%!test
%! given = struct ('value', [1, 2, 3], 'sd', [4, 5, 6], 'limits', [0; 1], ...
%!                 'bench', [1, 1, 2], 'covariance', magic (3) + magic (3)');
%! given.effects = struct ('name', 'e', 'laboratory', true, 'offset', 1:3);
%! given.reference = struct ('value', 7:9, 'sd', 1:3, 'trials', [1, 1, 1], ...
%!                           'scatter', false (1, 3), 'shared', zeros (1, 3));
%! some = newProblem (ofTargets (newProblem (given), [1, 3]));
%! assert ({some.value, some.targetNames, some.used}, {[1, 3], {'t1', 't3'}, 1:2});
%! assert (some.covariance, given.covariance([1, 3], [1, 3]));
%! assert ({some.effects.offset, some.reference.value}, {[1, 3], [7, 9]});

% SPDX-License-Identifier: GPL-3.0-only
