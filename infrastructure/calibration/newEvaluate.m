% NEWEVALUATE  Makes the function that runs the models of a case.
%
% CALL: EVALUATE = newEvaluate (CASE, SAY)
%
%   CASE      see newCase
%   SAY       function handle that takes one line of text
%   EVALUATE  [Z, BUDGET] = EVALUATE (P, E, REPLICATE, STAGE, BUDGET), see
%             addRuns: P n x d, E n x v (levels and effects, or effects alone),
%             REPLICATE n x 1, Z n x T, NaN where a run failed, NA (isna) where
%             a run of the set was not made because the budget has none left
%
% Where a model folder does not exist (a case of imported runs alone) nothing
% can be run: all is NA.

function evaluate = newEvaluate (Case, say)
  evaluate = @(P, E, replicate, stage, budget) ...
    bookedRuns ({P, E, replicate, stage}, budget, Case, say);
end

function [Z, budget] = bookedRuns (wanted, budget, Case, say)
  [P, E, replicate, stage] = wanted{:};
  if any (cellfun (@isempty, {Case.models.folder}))
    Z = NA (rows (P), numel (Case.targets));
    return
  end
  if any (strcmp (stage, {'infill', 'verify', 'replicate'}))
    stage = 'calibration';             % in the records these are one
  end
  plain = neutralEffects (Case);
  if columns (E) < numel (plain)             % effects alone: at the last level
    E = [repmat(plain(1:end - columns (E)), rows (P), 1), E];
  end
  Case.options.maxNewRuns = budget.left;
  [Case.models.seconds] = budget.seconds{:};
  [Z, records, isReused, nNew] = evaluateDEM (P, Case, replicate, stage, ...
                                              newProgress (stage, say), E);
  isLeftOut = strcmp ({records.cause}, 'budget');
  Z(isnan (Z) & any (reshape (isLeftOut, size (records)), 2)) = NA;
  failed = ~strcmp ({records.status}, 'ok') & ~isLeftOut;
  budget.seconds = {addSeconds(Case.models, records(:)').seconds};
  budget.isUsedUp = budget.isUsedUp || any (isLeftOut);
  budget.new = budget.new + nNew;
  budget.left = budget.left - nNew;
  budget.reused = budget.reused + sum (isReused(:));
  budget.failed = budget.failed + sum (failed);
  seconds = reshape ([records.seconds], size (records)) .* [Case.models.cpu];
  budget.coreSeconds = budget.coreSeconds + sum (seconds(isfinite (seconds)));
  v = numel (Case.coarse);
  if v > 0
    whole = all (strcmp (reshape ({records.status}, size (records)), 'ok'), 2);
    budget.levels = [budget.levels; E(whole, 1:v), sum(seconds(whole, :), 2)];
  end
end

%!function [Z, budget] = made (Case, sets, budget)
%!  evaluate = newEvaluate (Case, @(text) []);
%!  for P = sets
%!    [Z, budget] = evaluate (P{1}, [], 1, 'verify', budget);
%!  end
%!endfunction
%!test
%! Case = newCase (standInCase (tempname ()));
%! Case.options.maxNewRuns = 5;
%! [Z, budget] = made (Case, {[1, 2; 3, 4]}, newBudget (Case));
%! assert ([budget.new, budget.left, budget.isUsedUp], [4, 1, 0]);
%! [Z, budget] = made (Case, {[1, 2; 5, 6; 7, 8]}, budget);
%! assert ([budget.reused, budget.new, budget.isUsedUp], [2, 5, 1]);
%! assert (Z, [3, 2, -1; 11, 30, NA; NA, NA, NA], 1e-12);
%! assert (numel (listRunFolders (Case.store, 'First')), 3);
%!test
%! % one of two runs is not in the budget: the set was not tried
%! Case = newCase (standInCase (tempname ()));
%! Case.options.maxNewRuns = 3;
%! Z = made (Case, {[1, 2; 3, 4]}, newBudget (Case));
%! assert (any (isna (Z), 2), [false; true]);
%!test
%! % runs of later calls have the limit that the earlier ones gave
%! Case = newCase (standInCase (tempname ()));
%! made (Case, {[1, 2; 3, 4; 5, 6], [7, 8]}, newBudget (Case));
%! runs = listRunFolders (Case.store, 'First');
%! limit = @(name) isfile (fullfile (Case.store, 'optim', 'First', name, ...
%!                                   'limit'));
%! assert (limit (runs{4}));
