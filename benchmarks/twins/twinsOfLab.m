% TWINSOFLAB  Diagnoses the twins of one laboratory (a job of twinsDiagnose).
%
% CALL: VERDICTS = twinsOfLab (LAB, CASES)
%
%   LAB       struct name, problem, data (its runs), emulator ([]: is fitted to
%             them), middle (1 x T, any finite values)
%   CASES     struct Y (n x T), removed (1 x n, effect off the list or 0)
%   VERDICTS  1 x n struct, see twinsDiagnose
%
% The only place where the twin studies call the diagnosis.
%
% See also: twinsDiagnose

function verdicts = twinsOfLab (lab, cases)
  options = gapOptions ([]);
  given = lab.problem;
  given.value = lab.middle;
  problem = newProblem (given);
  if isempty (lab.emulator)
    lab.emulator = fitEmulator (problem, lab.data, options);
  end
  K = numel (lab.emulator.effect);
  full = gapReference (makeHypotheses (problem, lab.emulator, options));
  for removed = unique (cases.removed)
    hypotheses = full;
    if removed > 0
      hypotheses = makeHypotheses (problem, withoutEffects (lab.emulator, removed), ...
                                   options);
      hypotheses = gapReference (hypotheses);
    end
    numbersOf = find (cases.removed == removed);
    fits = fitLibrary (hypotheses, cases.Y(numbersOf, :));
    for i = 1:numel (numbersOf)
      verdicts(numbersOf(i)) = oneVerdict (hypotheses, fits, i, removed, K);
    end
  end
end

function v = oneVerdict (hypotheses, fits, i, removed, K)
  start = tic ();
  evidence = caseEvidence (hypotheses, fits, i);
  verdict = judgeCase (evidence, hypotheses);
  numbers = setdiff (1:K, removed);
  v = struct ('kind', verdict.kind, 'effects', numbers(verdict.effects), ...
              'lookAlike', verdict.lookAlike, 'guard', verdict.guard, ...
              'sameKind', verdict.sameKind, ...
              'partners', numbers(verdict.partners), ...
              'top', numbers(verdict.top), 'P', zeros (1, K + 3), ...
              'total', zeros (1, K), 'interval', NaN (K, 3), ...
              'gateP', evidence.gate.p, 'ess', min (evidence.ess), 'seconds', 0);
  v.total(numbers) = verdict.include;
  for h = 1:numel (verdict.P)
    switch evidence.kind{h}
      case 'null'
        place = 1;
      case 'single'
        place = 1 + numbers(evidence.members{h});
        k = evidence.members{h};
        v.interval(numbers(k), :) = strengthAlone (evidence, hypotheses, k);
      case 'pair'
        place = K + 2;
      otherwise
        place = K + 3;
    end
    v.P(place) = v.P(place) + verdict.P(h);
  end
  v.seconds = toc (start);
end

%!test
%! % intervals of the effects on the list, and of no other
%! pkg load stk
%! [given, data] = smallGapLab ();
%! lab = struct ('name', 'here', 'problem', given, 'data', data, ...
%!               'emulator', [], 'middle', mean (data.Z));
%! v = twinsOfLab (lab, struct ('Y', data.Z(end - 1:end, :), ...
%!                              'removed', [0, 1]));
%! K = numel (given.effects);
%! assert (size (v(1).interval), [K, 3]);
%! assert (all (diff (v(1).interval(:, [2, 1, 3]), 1, 2)(:) >= 0));
%! assert (isnan (v(2).interval(:, 1))', (1:K) == 1);

% SPDX-License-Identifier: GPL-3.0-only
