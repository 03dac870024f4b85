% WITHCONDITION  Makes the problem of a case that of a change.
%
% CALL: GIVEN = withCondition (GIVEN, CASE, C)
%
%   GIVEN  of newProblem, of the reference
%   CASE   see newCase;  C  number of one of its conditions
%   GIVEN  value, sd, trials, scatter of that condition; those of the reference
%          in the field reference, see newGapProblem

function given = withCondition (given, Case, c)
  names = {'value', 'sd', 'trials', 'scatter'};
  for name = names
    given.reference.(name{1}) = given.(name{1});
  end
  given.reference.perCondition = Case.perCondition;
  given.reference.condition = Case.conditions{c};
  for t = 1:numel (Case.targets)
    own = Case.targets(t).changed(c);
    if own.sd == 0
      own.sd = given.sd(t);
    end
    for name = names
      given.(name{1})(t) = own.(name{1});
    end
  end
end

%!test
%! Case = struct ('perCondition', [false, true], 'conditions', {{'moist'}});
%! Case.targets.changed = struct ('value', 7, 'sd', 0, 'trials', 3, ...
%!                                'scatter', true);
%! given = struct ('value', 5, 'sd', 0.2, 'trials', 1, 'scatter', false);
%! given = withCondition (given, Case, 1);
%! assert ({given.value, given.sd, given.trials, given.scatter}, ...
%!         {7, 0.2, 3, true});
%! assert (given.reference.value, 5);
%! assert (given.reference.condition, 'moist');
