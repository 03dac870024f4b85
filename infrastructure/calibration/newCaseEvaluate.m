% NEWCASEEVALUATE  Makes the function that carries out runs of the models of a case.
%
% CALL: [EVALUATE, BUDGET] = newCaseEvaluate (CASE, SAY)
%
%   CASE      see newCase
%   SAY       function handle that takes one line of text, see newSay
%   EVALUATE  [Z, BUDGET] = EVALUATE (P, E, REPLICATE, STAGE, BUDGET)
%   BUDGET    scalar struct; for both see newEvaluate, whose formulas know
%             neither a case nor a store
%
% Without a model folder (a case of imported runs alone) all is NA.
%
% Errors: those of runJobs

function [evaluate, budget] = newCaseEvaluate (Case, say)
  [~, budget] = newEvaluate ([]);
  budget.models = true (size (Case.models));
  budget.left = Case.options.maxNewRuns;
  budget.seconds = {Case.models.seconds};
  if any (cellfun (@isempty, {Case.models.folder}))
    budget.left = 0;
    budget.isUsedUp = true;
  end
  evaluate = @(P, E, replicate, stage, budget) ...
    bookedRuns ({P, E, replicate, stage}, budget, Case, say);
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
  [found, records, isReused, nNew, models] = ...
    evaluateDEM (P, Case, replicate, stage, newProgress (stage, say, further), E);
  Z = NaN (rows (P), numel (isOwn));
  Z(:, isOwn) = found;
  shaped = @(list) reshape (list, size (records));
  isLeftOut = shaped (strcmp ({records.cause}, 'budget'));
  isGood = shaped (strcmp ({records.status}, 'ok'));
  Z(isnan (Z) & any (isLeftOut, 2) & isOwn) = NA;
  budget.seconds(is) = {models.seconds};
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

%!function [Z, budget] = made (Case, sets)
%!  [evaluate, budget] = newCaseEvaluate (Case, @(text) []);
%!  for P = sets
%!    [Z, budget] = evaluate (P{1}, [], 1, 'verify', budget);
%!  end
%!endfunction
%!test
%! Case = readyCase ();
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
%! Case = readyCase ();
%! made (Case, {[1, 2; 3, 4; 5, 6], [7, 8]});
%! runs = listRunFolders (Case.store, 'First');
%! limit = @(name) isfile (fullfile (Case.store, 'optim', 'First', name, ...
%!                                   'limit'));
%! assert (limit (runs{4}));
%!test
%! % which effects a run had that gave nothing, and what it said
%! Case = readyCase ();
%! writeAtomic (fullfile (Case.models(2).folder, 'runscript'), "exit 7\n");
%! [Z, budget] = made (Case, {[1, 2]});
%! assert (isna (Z) | isnan (Z), [false, false, true]);
%! assert ({budget.lost.E, budget.lost.message}, {zeros(1, 0), 'exit status 7'});
%!test
%! % models that are not there: no run
%! Case.options.maxNewRuns = 16;
%! Case.models = struct ('folder', {'a', ''}, 'seconds', []);
%! [~, budget] = newCaseEvaluate (Case);
%! assert ({budget.left, budget.models}, {0, [true, true]});
%!test
%! % the second of two models alone; what the whole case runs then finds its runs
%! Case = readyCase ();
%! [evaluate, budget] = newCaseEvaluate (Case, @(text) []);
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

% SPDX-License-Identifier: GPL-3.0-only
