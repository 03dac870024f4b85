% WITHCONDITION  What is measured in a condition, beside the reference.
%
% CALL: GIVEN = withCondition (GIVEN, CASE, C)
%
%   GIVEN  struct of newProblem (CASE), of the reference
%   CASE   see newCase;  C  number of its condition
%   GIVEN  the same with value, sd, trials, scatter, shared, freedoms and swept
%          of the condition; those of the reference are in the field
%          reference, see newProblem, with together, the covariance of both
%
% A condition without an uncertainty has that of the reference. Readings of the
% same sessions share their errors, which are no part of the difference then. Of a
% curve this counts where all its points are of the same sessions.

function given = withCondition (given, Case, c)
  names = {'value', 'sd', 'trials', 'scatter', 'shared', 'freedom', ...
           'commonFreedom', 'sessionFreedom'};
  for name = names
    given.reference.(name{1}) = given.(name{1});
  end
  given.reference.perCondition = Case.perCondition;
  given.reference.condition = Case.conditions{c};
  T = numel (Case.targets);
  [before, after] = deal (cell (T, 1));
  given.swept = false (1, T);
  for t = 1:T
    target = Case.targets(t);
    changed = mergeFields (struct ('shared', 0, 'days', [], 'freedom', Inf, ...
                                   'commonFreedom', Inf, 'sessionFreedom', ...
                                   Inf), target.changed(c));
    if changed.sd == 0
      for name = {'sd', 'shared', 'freedom', 'commonFreedom', ...
                  'sessionFreedom'}
        changed.(name{1}) = given.(name{1})(t);
      end
    end
    for name = names
      given.(name{1})(t) = changed.(name{1});
    end
    given.swept(t) = givenField (changed, 'swept', false);
    before{t} = givenField (target, 'days', []);
    after{t} = changed.days;
  end
  given.reference.together = covarianceOf (before, after, given.series);
end

% Of what sessions bring to both: T x T.
function C = covarianceOf (before, after, series)
  T = numel (before);
  C = zeros (T);
  S = max (cellfun (@numel, [before; after]));
  rowOf = @(days) [days, zeros(1, S - numel (days))];
  A = cell2mat (cellfun (rowOf, before, 'UniformOutput', false));
  B = cell2mat (cellfun (rowOf, after, 'UniformOutput', false));
  for t = 1:T
    alike = find (series == series(t) & series > 0);
    if isempty (alike) || ~(areAlong (A(alike, :)) && areAlong (B(alike, :)))
      alike = t(series(t) == 0);
    end
    C(t, alike) = A(t, :) * B(alike, :)';
  end
end

function yes = areAlong (days)
  yes = rank (days, 1e-6 * max (norm (days), realmin)) <= 1;
end

%!test
%! % an error of the sessions is in both if they are the same
%! given = struct ('value', [1, 1, 1], 'sd', [1, 2, 2], 'trials', [2, 2, 2], ...
%!                 'scatter', [false, true, true], 'shared', [0.5, 1.5, 0], ...
%!                 'freedom', [3, 4, 5], 'commonFreedom', [1, 1, 1], ...
%!                 'sessionFreedom', [1, 2, 3], 'series', [0, 0, 0]);
%! changed = struct ('value', 7, 'sd', 1, 'trials', 3, 'scatter', true, ...
%!                   'shared', 0.5, 'days', {[0.3, 0.4], [0, 0, 0.5], []}, ...
%!                   'freedom', 9, 'commonFreedom', 5, 'sessionFreedom', 2);
%! Case.targets = struct ('changed', {changed(1), changed(2), changed(3)}, ...
%!                        'days', {[0.3, 0.4], [1.5, 0, 0], []});
%! [Case.perCondition, Case.conditions] = deal (true, {'moist'});
%! now = withCondition (given, Case, 1);
%! assert (now.reference.together, diag ([0.25, 0, 0]), 1e-12);
%! assert ({now.sd, now.freedom}, {[1, 1, 1], [9, 9, 9]});
%! assert ({now.reference.sd, now.reference.freedom}, {[1, 2, 2], [3, 4, 5]});
%! assert (now.swept, false (1, 3));
%! Case.targets(2).changed.swept = true;
%! Case.targets(2).changed.sd = 0;
%! now = withCondition (given, Case, 1);
%! assert ({now.sd, now.shared, now.freedom}, ...
%!         {[1, 2, 1], [0.5, 1.5, 0.5], [9, 4, 9]});
%! assert (now.swept, [false, true, false]);
%! % points of a curve share what their sessions bring
%! given.series = [1, 1, 0];
%! Case.targets(2).days = [0.6, 0.8];
%! Case.targets(2).changed.days = [0.6, 0.8];
%! now = withCondition (given, Case, 1);
%! assert (now.reference.together, [0.25, 0.5, 0; 0.5, 1, 0; 0, 0, 0], 1e-12);
%! Case.targets(2).days = [1, 0];
%! now = withCondition (given, Case, 1);
%! assert (now.reference.together, zeros (3));

% SPDX-License-Identifier: GPL-3.0-only
