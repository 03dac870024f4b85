% WITHOUTREADINGS  Asks whether a name survives without one kind of reading.
%
% CALL: [VERDICT, DECIDES] = withoutReadings (VERDICT, STUDY)
%
%   VERDICT  of judgeCase; one that names effects becomes a group where these
%            are not the likeliest ones without one kind of reading, or without
%            those that drift (PROBLEM.swept): with the effect that is then (guard
%            'readings', field decides). Where nearly all drift, nothing is named
%            (guard 'order')
%   STUDY    struct problem, emulator, hypotheses of newProblem, fitEmulator,
%            makeHypotheses
%   DECIDES  cellstr, as VERDICT.decides: PROBLEM.reading of those that decide
%
% A kind of reading (times, angles, lengths, each curve) is read off by one rule,
% and errors of the rule are in all of them. What rests on one kind alone, rests
% on that rule. Not asked where the others are no more than the parameters,
% or where nobody says what kind it is. A change that was read only before or only
% after the reference, while values drift, may be the drift.

function [verdict, decides] = withoutReadings (verdict, study)
  decides = {};
  if ~strcmp (verdict.kind, 'named')
    return
  end
  problem = study.problem;
  targets = study.hypotheses.white.columns;
  readings = problem.reading(targets);
  found = struct ('decides', {{}}, 'joined', verdict.effects);
  isSwept = problem.swept(targets);
  if any (isSwept)
    rest = targets(~isSwept);
    if numel (rest) <= study.emulator.p + 1
      verdict = openByOrder (verdict);
      return
    end
    found = askWithout (found, study, verdict, rest, ...
                        problem.targetNames(targets(isSwept)));
  end
  for reading = setdiff (readings, {''})(:)'
    rest = targets(~strcmp (readings, reading{1}));
    % no more targets than parameters are met by anything
    if numel (rest) > study.emulator.p + 1 && numel (rest) < numel (targets)
      found = askWithout (found, study, verdict, rest, reading);
    end
  end
  decides = found.decides;
  verdict.decides = decides;
  if ~isempty (decides)
    verdict.kind = 'group';
    verdict.guard = 'readings';
    verdict.effects = unique (found.joined);
    verdict.class = unique ([verdict.class, found.joined]);
    verdict.reason = sprintf ('without %s another one is likelier', ...
                              strjoin (decides, ', or '));
  end
end

% NAMES of the readings that are left out decide, if others are likelier then.
function found = askWithout (found, study, verdict, rest, names)
  first = likeliest (study, verdict, rest);
  if ~isequal (first, verdict.effects)
    found.decides = [found.decides, names];
    found.joined = [found.joined, first];
  end
end

function verdict = openByOrder (verdict)
  verdict.kind = 'undecided';
  verdict.guard = 'order';
  verdict.effects = zeros (1, 0);
  verdict.reason = 'values drift, and the change was read one way';
end

% As many effects as are named, the likeliest by the targets that are left (by
% Laplace's formula): the named ones, or with one of them another one of the
% five likeliest.
function first = likeliest (study, verdict, targets)
  hypotheses = makeHypotheses (study.problem, study.emulator, ...
                               study.hypotheses.options, targets);
  first = verdict.effects;
  [~, order] = sort (-verdict.include);
  tried = unique ([first, order(1:min (5, end))]);
  % no others are fitted
  hypotheses.list = hypotheses.list([1, hypotheses.singles(tried)]);
  hypotheses.singles(:) = 0;
  hypotheses.singles(tried) = 1 + (1:numel (tried));
  fits = fitLibrary (hypotheses, study.problem.value(targets));
  others = setdiff (tried, first);
  best = fitEffects (hypotheses, fits, 1, first, hypotheses.prior).logSum;
  for k = others
    for i = 1:numel (verdict.effects)
      members = verdict.effects;
      members(i) = k;
      fit = fitEffects (hypotheses, fits, 1, sort (members), hypotheses.prior);
      if fit.logSum > best
        best = fit.logSum;
        first = sort (members);
      end
    end
  end
end

%!test
%! % a cause that every bench shows, and one that one reading alone makes: the
%! % times, which the others contradict
%! pkg load stk
%! [given, data, means] = smallGapLab ();
%! given.value = means ([0.4, 0.6], [0, 0, 0.9, 0, 0]);
%! given.reading = repmat ({'length'}, 1, 12);
%! study = labStudy (given, data, struct ('twins', 60));
%! study.hypotheses = gapReference (study.hypotheses);
%! verdict = judgeCase (caseEvidence (study.hypotheses, study.fits, 1), study.hypotheses);
%! assert (verdict.kind, 'named');
%! given.reading(1:2:12) = {'time'};
%! study.problem = newProblem (given);
%! [same, decides] = withoutReadings (verdict, study);
%! assert ({same.kind, decides}, {'named', {}});
%! % named is what the times alone say
%! wrong = setfield (verdict, 'effects', 4);
%! [v, decides] = withoutReadings (wrong, study);
%! assert ({v.kind, v.guard}, {'group', 'readings'});
%! assert (v.effects, [3, 4]);
%! assert (decides, {'length', 'time'});
%! % what drifts, and was read one way, names nothing: the times alone, and all
%! given.reading(:) = {''};
%! given.swept = repmat ([true, false], 1, 6);
%! study.problem = newProblem (given);
%! assert (withoutReadings (verdict, study).kind, 'named');
%! v = withoutReadings (wrong, study);
%! assert ({v.guard, v.effects, v.decides}, {'readings', [3, 4], ...
%!         study.problem.targetNames(1:2:12)});
%! given.swept(:) = true;
%! study.problem = newProblem (given);
%! v = withoutReadings (verdict, study);
%! assert ({v.kind, v.guard, isempty(v.effects)}, {'undecided', 'order', true});

% SPDX-License-Identifier: GPL-3.0-only
