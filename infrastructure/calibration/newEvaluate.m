% NEWEVALUATE  Makes the function that carries out runs, and their budget.
%
% CALL: [EVALUATE, BUDGET] = newEvaluate (CASE, SAY)   the models of a case
%       [EVALUATE, BUDGET] = newEvaluate (F)           a formula
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
% Without a model folder (a case of imported runs alone) all is NA.

function [evaluate, budget] = newEvaluate (source, say)
  budget = struct ('left', Inf, 'models', true, 'sets', Inf, 'new', 0, 'reused', 0, ...
                   'failed', 0, 'cutOff', 0, 'coreSeconds', 0, 'seconds', {{[]}}, ...
                   'levels', [], 'isUsedUp', false, 'lost', ...
                   struct ('E', {}, 'message', {}));
  if isempty (source)
    evaluate = [];
  elseif isstruct (source)
    budget.models = true (size (source.models));
    budget.left = source.options.maxNewRuns;
    budget.seconds = {source.models.seconds};
    if any (cellfun (@isempty, {source.models.folder}))
      budget.left = 0;
      budget.isUsedUp = true;
    end
    evaluate = @(P, E, replicate, stage, budget) ...
      bookedRuns ({P, E, replicate, stage}, budget, source, say);
  else
    takesStage = nargin (source) < 0 || nargin (source) > 3;
    evaluate = @(P, E, replicate, stage, budget) ...
      counted (source ({P, E, replicate, stage}{1:3 + takesStage}), budget);
  end
end

function [Z, budget] = bookedRuns (wanted, budget, Case, say)
  [P, E, replicate, stage] = wanted{:};
  is = budget.models;
  isOwn = is([Case.targets.model]);
  Case = ofModels (Case, is);
  if any (cellfun (@isempty, {Case.models.folder}))
    Z = NA (rows (P), numel (isOwn));
    return
  end
  if any (strcmp (stage, {'infill', 'verify', 'replicate', 'repeat'}))
    stage = 'calibration';             % in the records these are one
  end
  plain = neutralEffects (Case);
  if columns (E) < numel (plain)             % effects alone: at the last level
    E = [repmat(plain(1:end - columns (E)), rows (P), 1), E];
  end
  Case.options.maxNewRuns = budget.left;
  [Case.models.seconds] = budget.seconds{is};
  further = furtherRuns (stage, rows (P), budget, Case);
  % The progress stays in no variable here: Octave 7 then keeps the frames of all
  % callers alive, and with them the lock of the case.
  [found, records, isReused, nNew] = ...
    evaluateDEM (P, Case, replicate, stage, newProgress (stage, say, further), E);
  Z = NaN (rows (P), numel (isOwn));
  Z(:, isOwn) = found;
  shaped = @(list) reshape (list, size (records));
  isLeftOut = shaped (strcmp ({records.cause}, 'budget'));
  isGood = shaped (strcmp ({records.status}, 'ok'));
  Z(isnan (Z) & any (isLeftOut, 2) & isOwn) = NA;
  budget.seconds(is) = {addSeconds(Case.models, records(:)').seconds};
  budget.isUsedUp = budget.isUsedUp || any (isLeftOut(:));
  budget.new = budget.new + nNew;
  budget.left = budget.left - nNew;
  budget.reused = budget.reused + sum (isReused(:));
  budget.failed = budget.failed + sum (~isGood(:) & ~isLeftOut(:));
  budget.cutOff = budget.cutOff + sum (strcmp ({records.cause}, 'time'));
  lost = lostRuns (records, ~isGood & ~isLeftOut, ...
                   E(:, numel (Case.coarse) + 1:end));
  % two empty structs in brackets lose their fields
  budget.lost(end + 1:end + numel (lost)) = lost;
  seconds = shaped ([records.seconds]) .* [Case.models.cpu];
  budget.coreSeconds = budget.coreSeconds + sum (seconds(isfinite (seconds)));
  v = numel (Case.coarse);
  if v > 0
    whole = all (isGood, 2);
    budget.levels = [budget.levels; E(whole, 1:v), sum(seconds(whole, :), 2)];
  end
end

% The case of some of its models.
function Case = ofModels (Case, is)
  isOwn = is([Case.targets.model]);
  number = num2cell (cumsum (is)([Case.targets(isOwn).model]));
  Case.models = Case.models(is);
  Case.targets = Case.targets(isOwn);
  [Case.targets.model] = number{:};
end

function lost = lostRuns (records, isLost, E)
  lost = struct ('E', {}, 'message', {});
  if isempty (E)                             % no effect, no level
    E = zeros (rows (isLost), 0);
  end
  [row, model] = find (isLost);
  for i = 1:numel (row)
    message = records(row(i), model(i)).message;
    lost(end + 1) = struct ('E', E(row(i), :), 'message', message);
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

%!function [Z, budget] = made (Case, sets)
%!  [evaluate, budget] = newEvaluate (Case, @(text) []);
%!  for P = sets
%!    [Z, budget] = evaluate (P{1}, [], 1, 'verify', budget);
%!  end
%!endfunction
% Runs that may follow these N sets, at most.
function n = furtherRuns (stage, sets, budget, Case)
  o = Case.options;
  rows_ = sets * sum (budget.models);
  made = budget.new + budget.reused + rows_;
  n = max ((o.numOfSam + o.maxFunEvals) * sum (budget.models) - made, 0);
  if strcmp (stage, 'gap')
    n = Inf;
  end
  n = max (min (n, budget.left - rows_), 0);
  n(~isfinite (n)) = 0;
end

%!test
%! Case = newCase (standInCase (tempname ()));
%! Case.options.maxNewRuns = 5;
%! [Z, budget] = made (Case, {[1, 2; 3, 4]});
%! assert ([budget.new, budget.left, budget.isUsedUp], [4, 1, 0]);
%! Case.options.maxNewRuns = 1;
%! [Z, budget] = made (Case, {[1, 2; 5, 6; 7, 8]});
%! assert ([budget.reused, budget.new, budget.isUsedUp], [2, 1, 1]);
%! % one of the two runs of a set is not in the budget: it was not tried
%! assert (Z, [3, 2, -1; 11, 30, NA; NA, NA, NA], 1e-12);
%! assert (numel (listRunFolders (Case.store, 'First')), 3);
%!test
%! % runs of later calls have the limit that the earlier ones gave
%! Case = newCase (standInCase (tempname ()));
%! made (Case, {[1, 2; 3, 4; 5, 6], [7, 8]});
%! runs = listRunFolders (Case.store, 'First');
%! limit = @(name) isfile (fullfile (Case.store, 'optim', 'First', name, ...
%!                                   'limit'));
%! assert (limit (runs{4}));
%!test
%! % which effects a run had that gave nothing, and what it said
%! Case = newCase (standInCase (tempname ()));
%! writeAtomic (fullfile (Case.models(2).folder, 'runscript'), "exit 7\n");
%! [Z, budget] = made (Case, {[1, 2]});
%! assert (isna (Z) | isnan (Z), [false, false, true]);
%! assert ({budget.lost.E, budget.lost.message}, {zeros(1, 0), 'exit status 7'});
%!test
%! % models that are not there: no run; a formula: any number
%! Case.options.maxNewRuns = 16;
%! Case.models = struct ('folder', {'a', ''}, 'seconds', []);
%! [~, budget] = newEvaluate (Case);
%! assert ({budget.left, budget.models}, {0, [true, true]});
%! [f, budget] = newEvaluate (@(P, E, r, stage) [P + E, merge(r > 1, NaN, r)]);
%! [Z, budget] = f ([1; 2], [3; 4], [1; 2], 'plan', budget);
%! assert (Z, [4, 1; 6, NaN]);
%! assert ([budget.new, budget.failed, budget.isUsedUp], [2, 1, 0]);
%!test
%! % the second of two models alone; what the whole case runs then finds its runs
%! Case = newCase (standInCase (tempname ()));
%! [evaluate, budget] = newEvaluate (Case, @(text) []);
%! budget.models = [false, true];
%! [Z, budget] = evaluate ([1, 2; 3, 4], [], 1, 'plan', budget);
%! assert (Z, [NaN, NaN, -1; NaN, NaN, -1], 1e-12);
%! assert (budget.new, 2);
%! assert (cellfun (@numel, budget.seconds), [0, 2]);
%! assert (isempty (listRunFolders (Case.store, 'First')));
%! budget.models = [true, true];
%! [Z, budget] = evaluate ([1, 2; 3, 4], [], 1, 'plan', budget);
%! assert (Z, [3, 2, -1; 7, 12, -1], 1e-12);
%! assert ([budget.new, budget.reused], [4, 2]);
