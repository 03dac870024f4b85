% NEWEVALUATE  Makes the function that evaluates a formula as runs, and their budget.
%
% CALL: [EVALUATE, BUDGET] = newEvaluate (F)
%
%   F         handle Z = F (P, E, REPLICATE), or with a fourth argument, STAGE;
%             []: nothing to run, EVALUATE is []
%   EVALUATE  [Z, BUDGET] = EVALUATE (P, E, REPLICATE, STAGE, BUDGET), see
%             addRuns: P n x d, E n x v (levels and effects, or effects alone),
%             REPLICATE n x 1, Z n x T, NaN where a run failed, NA (isna) where
%             a run of the set was not made because the budget has none left
%   BUDGET    scalar struct, in runs (one a model and set): left; models (1 x M
%             logical, those that a set runs: Z is NaN for the others); new,
%             reused (from the store), failed, of them cutOff (at a time
%             limit); coreSeconds; seconds (1 x M cell, see addSeconds); levels (n x (v + 1):
%             levels of a set that was run, its core-seconds); sets (that a diagnosis
%             may still ask for, those of the store too: Inf); isUsedUp: a run
%             that was wanted was not made; lost (1 x n struct, runs without a
%             result: E (1 x v, effects), message). It travels in the state
%
% The models of a case: newCaseEvaluate.

function [evaluate, budget] = newEvaluate (formula)
  budget = struct ('left', Inf, 'models', true, 'sets', Inf, 'new', 0, 'reused', 0, ...
                   'failed', 0, 'cutOff', 0, 'coreSeconds', 0, 'seconds', {{[]}}, ...
                   'levels', [], 'isUsedUp', false, 'lost', ...
                   struct ('E', {}, 'message', {}));
  evaluate = [];
  if ~isempty (formula)
    takesStage = nargin (formula) < 0 || nargin (formula) > 3;
    evaluate = @(P, E, replicate, stage, budget) ...
      counted (formula ({P, E, replicate, stage}{1:3 + takesStage}), budget);
  end
end

function [Z, budget] = counted (Z, budget)
  isTried = ~any (isna (Z), 2);
  n = sum (isTried) * sum (budget.models);
  budget.new = budget.new + n;
  budget.left = budget.left - n;
  budget.failed = budget.failed + sum (any (isnan (Z(isTried, :)), 2));
  budget.isUsedUp = budget.isUsedUp || ~all (isTried);
end

%!test
%! % a formula: any number of runs
%! [f, budget] = newEvaluate (@(P, E, r, stage) [P + E, merge(r > 1, NaN, r)]);
%! [Z, budget] = f ([1; 2], [3; 4], [1; 2], 'plan', budget);
%! assert (Z, [4, 1; 6, NaN]);
%! assert ([budget.new, budget.failed, budget.isUsedUp], [2, 1, 0]);

% SPDX-License-Identifier: GPL-3.0-only
