% COMPLETEPLAN  Runs what the plan of a case lacks for a diagnosis.
%
% CALL: STATE = completePlan (STATE, PROBLEM, CASE, SAY, OPTIONS)
%
%   STATE    see addRuns: data of gatherRuns
%   PROBLEM  see newProblem;  CASE  see newCase
%   SAY      function handle that takes one line of text
%   OPTIONS  see gapOptions
%
% Of the models that STATE.budget.models leaves in. First sets that benches lack which
% joined the case later (completeBenches).
% Then neutral sets: a diagnosis wants options.neutral (d + 1), 40 at most, if it may
% run them, and mends its surrogates where that was not enough (diagnoseMatrices);
% without new runs it takes what is there. A bench all of whose runs gave no
% result, d + 3 or more, is not waited for: enterRuns leaves it out.

function state = completePlan (state, problem, Case, say, options)
  d = numel (Case.names);
  wanted = max (Case.options.numOfSam, min (options.neutral * (d + 1), 40));
  state = completeBenches (state, Case, say, wanted);
  data = state.data;
  [~, phi] = neutralEffects (Case);
  % a bench on which no run gives a result must not hold up the others
  isDead = ~any (isfinite (data.Z), 1) & ...
           sum (isnan (data.Z) & ~isna (data.Z), 1) >= d + 3;
  isDone = isDead | ~askedResults (state.budget, [Case.targets.model]);
  neutral = all (data.E == phi, 2) & all (isfinite (data.Z) | isDone, 2);
  have = rows (unique (data.X(neutral, :), 'rows'));
  % coarse sets count, but d + 3 have to be of the last level
  [atLast, hasLevels] = isFine (data);
  if hasLevels
    wanted = max (wanted, have + d + 3 - sum (neutral & atLast));
  end
  missing = min (wanted - have, floor (state.budget.left / sum (state.budget.models)));
  if missing < 1
    return
  end
  there = countText (have, 'run without effects exists', 'runs without effects exist');
  say (sprintf ('plan: %s; %d will be added', there, missing));
  P = planBeside (data.X(neutral, :), missing, Case);
  n = rows (P);
  state = addRuns (state, problem, P, repmat (phi, n, 1), 'plan', ones (n, 1));
end

% Of the sets that most benches have, but not all, these get the missing runs:
% neutral ones until there are those of a plan, and half of those of each
% effect, eight at least, of all strengths: one that has no runs on a bench
% could be anything there, and fewer than eight do not tell how it bends
% (learnEffect). What a set has, from the store or a table, is not run again.
% Rows of one bench alone, runs of tests (tryMeasurements), stay as they are.
function state = completeBenches (state, Case, say, wanted)
  data = state.data;
  model = [Case.targets.model];
  isAsked = askedResults (state.budget, 1:numel (Case.models));
  M = sum (isAsked);
  wasRun = false (rows (data.X), 0);
  for k = find (isAsked)
    wasRun(:, end + 1) = ~any (isna (data.Z(:, model == k)), 2);
  end
  n = sum (wasRun, 2);
  at = wantedSets (data.E, n == M, n < M & n >= M / 2, Case, ...
                   wanted);
  missing = M - n(at);
  at = at(cumsum (missing) <= state.budget.left);
  if isempty (at)
    return
  end
  say ([countText(numel (at), 'run'), ' on a rig without runs']);
  for has = unique (wasRun(at, :), 'rows')'
    sets = at(all (wasRun(at, :) == has', 2));
    state.budget.models = isAsked;
    state.budget.models(isAsked) = ~has';
    [Z, state.budget] = state.evaluate (data.X(sets, :), data.E(sets, :), ...
                                        data.replicate(sets), 'gap', ...
                                        state.budget);
    isNew = state.budget.models(model);
    state.data.Z(sets, isNew) = Z(:, isNew);
  end
  state.budget.models = isAsked;
end

function at = wantedSets (E, isWhole, isOpen, Case, plan)
  [~, phi] = neutralEffects (Case);
  isOff = E == phi;
  neutral = all (isOff, 2);
  at = find (neutral & isOpen);
  at = at(1:min (end, max (plan - sum (neutral & isWhole), 0)));
  last = 0;
  for effect = Case.effects
    v = numel (effect.variables);
    ofEffect = last + (1:v);
    last = last + v;
    if v == 0
      continue
    end
    others = setdiff (1:columns (E), ofEffect);
    alone = all (isOff(:, others), 2) & ~neutral;
    open = find (alone & isOpen);
    wanted = max (8, ceil (sum (alone & (isOpen | isWhole)) / 2));
    wanted = min (wanted - sum (alone & isWhole), numel (open));
    strength = max (abs (E(open, ofEffect) - phi(ofEffect)) ./ ...
                    max (abs (effect.limits - phi(ofEffect))), [], 2);
    [~, order] = sort (-strength);
    some = order(round (linspace (1, numel (order), max (wanted, 0))));
    at = [at; open(some(:))];
  end
end

%!function [Z, budget] = thirdAlone (P, E, r, stage, budget)
%!  % no other bench may be run, and what it has stays
%!  assert (budget.models, [false, false, true]);
%!  Z = [7 * P, 7 * P, r, P];
%!  [budget.new, budget.left] = deal (budget.new + rows (P), budget.left - rows (P));
%!endfunction
%!test
%! % two benches that all sets have, a third that joined: of 20 neutral sets 12
%! % are wanted, of 15 of the effect eight, the strongest among them
%! pkg load stk
%! Case = struct ('names', {{'a'}}, 'coarse', [], 'limits', [0; 1], ...
%!                'folder', '');
%! Case.options = struct ('numOfSam', 12, 'seed', 1);
%! Case.models = struct ('name', {'A', 'B', 'C'});
%! Case.targets = struct ('model', {1, 2, 3, 3});
%! Case.effects = struct ('name', 'e', 'variables', {{'e'}}, 'neutral', 0, ...
%!                        'limits', [0; 2], 'laboratory', false);
%! [~, state.budget] = newEvaluate ([]);
%! state.budget.models = true (1, 3);
%! state.evaluate = @thirdAlone;
%! [Case.kept, Case.unit, Case.bench] = deal (1:4, ones (1, 4), [1, 2, 3, 3]);
%! X = (1:35)' / 36;
%! E = [zeros(20, 1); 2 * (1:15)' / 15];
%! state.data = addRows (newData (1, 4, 1), X, [X, X + E, NA(35, 2)], ...
%!                       ones (35, 1), 'plan', E);
%! % a run of a test: on the new bench alone
%! state.data = addRows (state.data, 0.5, [NA, NA, 1, 0.5], 1, 'next', 0);
%! full = completePlan (state, Case, Case, @(t) [], gapOptions ([]));
%! known = isfinite (full.data.Z(:, 3));
%! assert (rows (full.data.X), 36);
%! assert (full.data.Z(:, 1:2), state.data.Z(:, 1:2));
%! assert ([sum(known(1:20)), sum(known(21:35)), known(36)], [12, 8, 1]);
%! assert (known(35));
%! assert (full.data.Z(known, 4), full.data.X(known), 1e-12);
%! assert (full.budget.new, 20);
%! % once done nothing is wanted; a budget that ends cuts off
%! again = completePlan (full, Case, Case, @(t) [], gapOptions ([]));
%! assert (again.budget.new, 20);
%! state.budget.left = 9;
%! few = completePlan (state, Case, Case, @(t) [], gapOptions ([]));
%! assert (sum (isfinite (few.data.Z(1:35, 3))), 9);
%!test
%! % a bench that has never given a result is not waited for, once it is sure
%! pkg load stk
%! Case = struct ('names', {{'a'}}, 'effects', [], 'coarse', [], ...
%!                'limits', [0; 1], 'folder', '', 'models', ...
%!                struct ('name', {'A', 'B'}), 'targets', ...
%!                struct ('model', {1, 2}));
%! Case.options = struct ('numOfSam', 12, 'seed', 1);
%! [state.evaluate, state.budget] = newEvaluate (@(P, E, r) [P, P]);
%! [Case.kept, Case.unit, Case.bench] = deal (1:2, ones (1, 2), 1:2);
%! state.data = addRows (newData (1, 2), (1:12)' / 13, ...
%!                       [(1:12)', NaN(12, 1)], ones (12, 1), 'plan');
%! assert (rows (completePlan (state, Case, Case, @(t) [], ...
%!                              gapOptions ([])).data.X), 12);
%! % neutral sets are 40 at most
%! many = gapOptions (struct ('neutral', 30));
%! assert (rows (completePlan (state, Case, Case, @(t) [], many).data.X), 40);
%! state.data = keepRows (state.data, 1:3);
%! assert (rows (completePlan (state, Case, Case, @(t) [], ...
%!                              gapOptions ([])).data.X), 15);

% SPDX-License-Identifier: GPL-3.0-only
