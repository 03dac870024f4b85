% COMPARECONDITIONS  Lays the verdicts on several conditions side by side.
%
% CALL: S = compareConditions (DIAGNOSIS, OTHERS)
%
%   DIAGNOSIS  of diagnoseMatrices, of one more condition
%   OTHERS     conditions of S of those before ([]: none)
%   S          struct
%     conditions  1 x C struct, this one first: name, verdict, effects
%                 (cellstr), lookAlike, p, probability (of each effect),
%                 strength and interval90 (of each effect, shares of its range)
%     order       1 x m struct: effect, more, less (names of conditions),
%                 probability: two conditions of one cause, in which there is
%                 more of it
%   conditions is empty where the diagnosis is not one of a change
%
% The probability takes the strengths as normal, with the widths of their
% intervals: they are from one set of surrogates, whose common error it counts
% twice.

function s = compareConditions (diagnosis, others)
  s = struct ('conditions', others, 'order', ...
              struct ('effect', {}, 'more', {}, 'less', {}, 'probability', {}));
  if isempty (diagnosis.gapProblem.reference)
    return
  end
  which = diagnosis.which;
  one = struct ('name', diagnosis.gapProblem.reference.condition, ...
                'verdict', which.verdict, 'effects', {which.effects}, ...
                'lookAlike', which.lookAlike, 'p', which.gateP, ...
                'probability', [], 'strength', [], 'interval90', []);
  for name = which.effects
    own = which.strength(strcmp ({which.strength.name}, name{1}));
    one.probability(end + 1) = ...
      which.posterior.(matlab.lang.makeValidName (name{1}));
    one.strength(end + 1) = own.value;
    one.interval90(end + 1, :) = own.interval90;
  end
  s.conditions = [one, others];
  for i = 1:numel (s.conditions)
    for j = 1:i - 1
      s.order = [s.order, orderOf(s.conditions(j), s.conditions(i))];
    end
  end
end

function order = orderOf (a, b)
  order = [];
  for name = intersect (a.effects, b.effects)
    i = find (strcmp (a.effects, name{1}));
    j = find (strcmp (b.effects, name{1}));
    sd = sqrt (widthOf (a.interval90(i, :))^2 + widthOf (b.interval90(j, :))^2);
    p = 1 - normalTail ((a.strength(i) - b.strength(j)) / sd);
    names = {a.name, b.name};
    if p < 0.5
      names = names([2, 1]);
      p = 1 - p;
    end
    order = [order, struct('effect', name{1}, 'more', names{1}, ...
                           'less', names{2}, 'probability', p)];
  end
end

function sd = widthOf (interval)
  sd = max (diff (interval) / 3.29, realmin);
end

%!test
%! w = struct ('verdict', 'named', 'effects', {{'cohesion'}}, 'lookAlike', ...
%!             false, 'gateP', 0.01, 'posterior', struct ('cohesion', 0.9));
%! w.strength = struct ('name', 'cohesion', 'value', 0.6, ...
%!                      'interval90', [0.5, 0.7]);
%! d = struct ('which', w, 'gapProblem', struct ('reference', ...
%!             struct ('condition', 'wet')));
%! s = compareConditions (d, []);
%! assert (isempty (s.order));
%! d.gapProblem.reference.condition = 'moist';
%! d.which.strength.value = 0.3;
%! d.which.strength.interval90 = [0.2, 0.4];
%! s = compareConditions (d, s.conditions);
%! assert ({s.conditions.name}, {'moist', 'wet'});
%! assert ({s.order.more, s.order.less}, {'wet', 'moist'});
%! assert (s.order.probability > 0.99);
%! d.gapProblem.reference = [];
%! assert (isempty (compareConditions (d, []).conditions));
