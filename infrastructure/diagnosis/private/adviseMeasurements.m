% ADVISEMEASUREMENTS  Ranks what could be measured next, on other benches, too.
%
% CALL: [TESTS, FURTHER] = adviseMeasurements (STUDY, EVIDENCE, VERDICT, STATE)
%       [TESTS, STATE] = FURTHER ()
%
%   STUDY    struct problem, emulator, hypotheses, fits, see runCures. Where problem
%            has a field tests, it is a handle without arguments that gives the
%            CANDIDATES of tryMeasurements: tests that the case does not have
%   EVIDENCE  of caseEvidence;  VERDICT  of judgeCase
%   STATE    of newGapState; comes back with the runs in its budget
%   TESTS    1 x m struct of nextMeasurement. First those that tell options.adviseAt or
%            more, best per cost first, then the others; last those that were
%            given up early (isFirm). The first one is the advice, where it
%            tells so much. At first they cost no run
%   FURTHER  [], or a handle that tries the CANDIDATES by runs and ranks all
%
% Tests of other benches cost runs, so they are tried only where it is open
% which kind of cause it is, or whether it is the likeliest one itself: a group,
% an undecided verdict, or a name beside which a look-alike stands; not where
% surrogates or integrals are to blame. They may take as long as all runs before:
% who asks says the verdict first, then calls FURTHER. They are a wing, otherRigs/:
% without it none is tried.

function [tests, further] = adviseMeasurements (study, evidence, verdict, state)
  tests = nextMeasurement (study.problem, study.emulator, evidence, verdict.P, ...
                           study.hypotheses.options);
  tests = ranked (tests, study.hypotheses.options);
  further = [];
  if wantsOthers (study.problem, verdict, state)
    candidates = study.problem.tests ();
    if ~isempty (candidates)
      trials = @() tryMeasurements (candidates, study, evidence, verdict.P, state);
      further = @() withTried (tests, trials, study.hypotheses.options);
    end
  end
end

function yes = wantsOthers (problem, verdict, state)
  isOpen = any (strcmp (verdict.kind, {'group', 'undecided'})) || ...
           (strcmp (verdict.kind, 'named') && verdict.lookAlike);
  yes = isOpen && ~any (strcmp (verdict.guard, {'surrogate', 'integral'})) && ...
        isfield (problem, 'tests') && exist ('tryMeasurements', 'file') == 2 && ...
        state.budget.left >= 4;
end

function [tests, state] = withTried (tests, trials, options)
  [fresh, state] = trials ();
  tests = ranked ([tests, fresh], options);
end

function tests = ranked (tests, options)
  isFirm = [tests.isFirm];
  % worth advising, then worth less, last those that were given up early
  place = 1 + (~isFirm | [tests.gain] < options.adviseAt) + ~isFirm;
  [~, order] = sortrows ([place; -[tests.gainPerCost]]');
  tests = tests(order);
end

%!test
%! % two causes that look alike here; of three tests that the case does not have
%! % the one that parts them is advised, given back it tells them apart
%! pkg load stk
%! [given, data, means] = smallGapLab ();
%! randn ('twister', 10);
%! truth = [0.6, 0, 0, 0, 0];
%! given.value = means ([0.4, 0.6], truth) + 0.28 * randn (1, 12);
%! % other benches: cohesion and bridge apart, one that nothing moves
%! % and one that fails
%! laws = {@(X, E) [5 + 4 * E(:, 1), 7 - 3 * E(:, 2) + X(:, 1)], ...
%!         @(X, E) [5 + X(:, 1), 7 + X(:, 2)], @(X, E) NaN(rows (X), 2)};
%! for k = 1:3
%!   [f, budget] = newEvaluate (@(P, E, r) laws{k}(P, E) + ...
%!                              0.2 * randn (rows (P), 2));
%!   effects = struct ('offset', cell (1, 5), 'matrix', zeros (2));
%!   [effects.offset] = deal ([0, 0]);
%!   list(k) = struct ('test', sprintf ('bench %d', k), 'model', 'Other', ...
%!                     'variable', 'v', 'value', k, 'trials', 3, 'cost', 1, ...
%!                     'origin', [NaN, NaN], 'noise', [0.2, 0.2], ...
%!                     'size', [5, 7], 'sd', [0.1, 0.1], ...
%!                     'effects', effects, 'isExpressed', true (1, 5), ...
%!                     'evaluate', f, 'lines', {{}});
%! end
%! given.tests = @() list;
%! study = labStudy (given, data, struct ('twins', 60));
%! study.hypotheses = gapReference (study.hypotheses);
%! evidence = caseEvidence (study.hypotheses, study.fits, 1);
%! verdict = judgeCase (evidence, study.hypotheses);
%! assert (verdict.kind, 'group');
%! state.budget = budget;
%! [tests, further] = adviseMeasurements (study, evidence, verdict, state);
%! assert (all ([tests.runs] == 0));
%! [tests, state] = further ();
%! assert (tests(1).test, 'bench 1');
%! assert (tests(1).gain > 0.6);
%! assert (sort (tests(1).between), {'bridge', 'cohesion'});
%! assert (tests(1).runs, 20);
%! at = find (strcmp ({tests.test}, 'bench 2'));
%! assert (tests(at).gain < 0.2);
%! assert (~any (strcmp ({tests.test}, 'bench 3')));
%! % eight of the second or those of the best too, four of the third in vain
%! assert (any (tests(at).runs == [8, 20]));
%! assert (state.budget.new, 4 + tests(1).runs + tests(at).runs);
%! % a sure verdict, a budget that is used up: nothing is run
%! sure = verdict;
%! [sure.kind, sure.lookAlike] = deal ('named', false);
%! [~, further] = adviseMeasurements (study, evidence, sure, state);
%! assert (isempty (further));
%! state.budget.left = 3;
%! [~, further] = adviseMeasurements (study, evidence, verdict, state);
%! assert (isempty (further));
%! state.budget.left = 100;
%! study.problem.tests = @() [];
%! [~, further] = adviseMeasurements (study, evidence, verdict, state);
%! assert (isempty (further));

% SPDX-License-Identifier: GPL-3.0-only
