% WITHCONDITION  What is measured in a condition, beside the reference.
%
% CALL: GIVEN = withCondition (GIVEN, CASE, C)
%
%   GIVEN  struct of newProblem (CASE), of the reference
%   CASE   see newCase;  C  number of its condition
%   GIVEN  the same with value, sd, trials, scatter, shared of the condition;
%          those of the reference are in the field reference, see newProblem
%
% A condition without an uncertainty has that of the reference. What sessions
% make (shared) is in both where both were measured in the same ones, and then
% no part of their difference.

function given = withCondition (given, Case, c)
  names = {'value', 'sd', 'trials', 'scatter', 'shared'};
  for name = names
    given.reference.(name{1}) = given.(name{1});
  end
  given.reference.perCondition = Case.perCondition;
  given.reference.condition = Case.conditions{c};
  for t = 1:numel (Case.targets)
    changed = mergeFields (struct ('shared', 0, 'sameSessions', false), ...
                           Case.targets(t).changed(c));
    if changed.sd == 0
      [changed.sd, changed.shared] = deal (given.sd(t), given.shared(t));
    end
    if changed.sameSessions
      changed.sd = sqrt (changed.sd^2 - changed.shared^2);
      changed.shared = 0;
      given.reference.sd(t) = sqrt (given.reference.sd(t)^2 - ...
                                    given.reference.shared(t)^2);
    end
    for name = names
      given.(name{1})(t) = changed.(name{1});
    end
  end
end

%!test
%! % an error of the sessions is in both if they are the same
%! given = struct ('value', [1, 1], 'sd', [1, 2], 'trials', [2, 2], ...
%!                 'scatter', [false, true], 'shared', [0.6, 1.2]);
%! changed = @(same) struct ('value', 7, 'sd', 1, 'trials', 3, 'scatter', ...
%!                           true, 'shared', 0.8, 'sameSessions', same);
%! Case.targets = struct ('changed', {changed(true), changed(false)});
%! [Case.perCondition, Case.conditions] = deal (true, {'moist'});
%! now = withCondition (given, Case, 1);
%! assert (now.sd, [0.6, 1], 1e-12);
%! assert (now.shared, [0, 0.8]);
%! assert (now.reference.sd, [0.8, 2], 1e-12);
%! assert (now.reference.value, [1, 1]);
%! Case.targets(1).changed = rmfield (Case.targets(1).changed, ...
%!                                    {'sameSessions', 'shared'});
%! Case.targets(1).changed.sd = 0;
%! now = withCondition (given, Case, 1);
%! assert ([now.sd; now.shared], [1, 1; 0.6, 0.8]);
