% PROVECAUSE  Runs the model with its cause, which may change the verdict.
%
% CALL: [VERDICT, EVIDENCE, CURE, STATE] = proveCause (VERDICT, STUDY, STATE)
%
%   VERDICT     of judgeCase
%   STUDY       struct problem, emulator, hypotheses, fits, as of runCures, and evidence
%               of caseEvidence
%   STATE       of newGapState
%   VERDICT, EVIDENCE  where DEM has run the cause: with these runs known and the
%               held-out targets in the evidence
%   CURE        of measureCure, for the cause that VERDICT tells then; []
%               where there is nothing to compare
%
% Compared are the likeliest cause and those that are less likely by a factor of
% exp (classNats) at most, three in all, each with as many runs at the set where
% it fits: evidence that counts the runs of one alone would favour it. Where no
% other one is likely, the one whose mark on the targets is most like that of the
% cause is a placebo, as one that cannot imitate it proves nothing. Where these
% runs turn up another cause, a pair say, it is compared too: a name must not be
% judged by the cure of another one.
% Where DEM still misses a target, the surrogates of the cause were wrong there:
% fitted again with these runs they give a nearer set, which is run, twice at
% most. DEM runs are spent on a name or a group only.

function [verdict, evidence, cure, state] = proveCause (verdict, study, state)
  cure = [];
  evidence = study.evidence;
  causes = comparedCauses (verdict, evidence, study.hypotheses.options);
  if isempty (causes)
    return
  end
  if ~isSaid (verdict)
    % what is not said needs no proof: surrogates compare it
    state.evaluate = [];
  end
  [sets, state] = runCures (study, causes, state);
  if all ([sets.verified])
    [verdict, evidence] = withCures (study, state.data);
  end
  retries = 2 * all ([sets.verified]);
  while true
    cause = causeOf (verdict, causes);
    if ~isAmong (cause, {sets.h})
      [sets, state] = runCures (study, {cause}, state, sets);
    end
    cure = measureCure (study, sets, cause);
    if retries < 1 || state.budget.sets < 2 || ~isSaid (verdict) || ...
       ~cure.stillMisses
      return
    end
    % what DEM said of this set is known now: the next one is nearer
    retries = retries - 1;
    study = refit (study, state.data, study.problem.used);
    sets = sets(~cellfun (@(h) isequal (h, cause), {sets.h}));
    [sets, state] = runCures (study, {cause}, state, sets);
    [verdict, evidence] = withCures (study, state.data);
  end
end

% The runs of the cures stand where each effect would have to be, so they are
% the best runs of it; the held-out targets were never fitted. The evidence of
% all targets is that of the used ones times the predictive density of the
% held-out ones. Whether there is a gap was decided before.
function [verdict, evidence] = withCures (study, data)
  problem = study.problem;
  known = refit (study, data, sort ([problem.used, problem.heldOut]));
  evidence = caseEvidence (known.hypotheses, known.fits, 1);
  evidence.gate = study.evidence.gate;
  verdict = judgeCase (evidence, known.hypotheses);
end

% The study with what DATA tell, on TARGETS.
function study = refit (study, data, targets)
  problem = study.problem;
  options = study.hypotheses.options;
  emulator = emulate (problem, data, options, study.emulator);
  isLeft = ismember ({emulator.effect.name}, study.hypotheses.names);
  study.emulator = withoutEffects (emulator, find (~isLeft));
  reference = study.hypotheses.reference;
  study.hypotheses = makeHypotheses (problem, study.emulator, options, targets);
  study.hypotheses.reference = reference;
  study.fits = fitLibrary (study.hypotheses, problem.value(targets));
end

function is = isSaid (verdict)
  is = any (strcmp (verdict.kind, {'named', 'group'}));
end

function is = isAmong (h, list)
  is = any (cellfun (@(own) isequal (own, h), list));
end

% The cause and its rivals; at least one other effect, as a placebo.
function causes = comparedCauses (verdict, evidence, options)
  causes = {};
  if isempty (verdict.include) || strcmp (verdict.kind, 'surrogate')
    return
  end
  [~, order] = sort (-verdict.include);
  first = verdict.top;
  if strcmp (verdict.kind, 'named')
    first = verdict.effects;
  elseif strcmp (verdict.kind, 'group')
    first = order(find (ismember (order, verdict.effects), 1));
  end
  others = order(~ismember (order, first));
  near = natsBehind (evidence, verdict, first)(others) <= options.classNats;
  isMember = ismember (others, verdict.effects) | near;
  rivals = others(isMember)(1:min (2, sum (isMember)));
  if isempty (rivals) && ~isempty (others)
    alike = max (evidence.screen.cosine(first, others), [], 1);
    % what cannot be seen could not imitate the cause
    [~, best] = max (alike .* isfinite (evidence.screen.smallest(others)));
    rivals = others(best);
  end
  causes = [{first}, num2cell(rivals)];
end

% What is said in the end; of a group its likeliest member that was run.
function cause = causeOf (verdict, causes)
  cause = causes{1};
  if strcmp (verdict.kind, 'named')
    cause = verdict.effects;
  elseif isAmong (verdict.top, causes) && ...
         ~isempty (verdict.effects) && ~isequal (verdict.effects, cause)
    cause = verdict.top;
  end
end

%!test
%! % two causes of which only one was said: the runs turn up both, and what is
%! % compared in the end is both
%! [given, data, means] = smallGapLab ();
%! given.value = means ([0.4, 0.6], [0, 0, 0.6, 0.6, 0]);
%! study = labStudy (given, data, struct ('twins', 99));
%! study.hypotheses = gapReference (study.hypotheses);
%! study.evidence = caseEvidence (study.hypotheses, study.fits, 1);
%! verdict = judgeCase (study.evidence, study.hypotheses);
%! verdict.kind = 'group';
%! [verdict.effects, verdict.top] = deal (3);
%! runs = @(X, E, r, stage) means (X, [E, zeros(rows (E), 1)]) + ...
%!        0.05 * randn (rows (X), 12);
%! options = gapOptions (struct ('maxNewRuns', 16, 'verifyRuns', 3));
%! state = newGapState (data, options, runs);
%! [verdict, ~, cure, state] = proveCause (verdict, study, state);
%! assert (verdict.kind, 'named');
%! assert (verdict.effects, [3, 4]);
%! assert (cure.effect, 'spread + size');
%! assert (cure.verifiedByDEM);
%! assert (cure.closure > 0.9);
%! assert (~any (strcmp ({cure.placebos.effect}, 'size')));
%! assert (state.budget.sets, 16 - 4 * 3);

%!test
%! % no other effect is likely: the placebo is the one most like the cause; one
%! % within 6 nats is compared instead
%! [given, data, means] = smallGapLab ();
%! given.value = means ([0.4, 0.6], [0, 0, 0.9, 0, 0]);
%! study = labStudy (given, data, struct ('twins', 99));
%! study.hypotheses = gapReference (study.hypotheses);
%! study.evidence = caseEvidence (study.hypotheses, study.fits, 1);
%! verdict = judgeCase (study.evidence, study.hypotheses);
%! [verdict.kind, verdict.effects, verdict.top] = deal ('named', 3, 3);
%! state = newGapState (data, gapOptions ([]), []);
%! placebos = cell (1, 2);
%! for i = 1:2
%!   verdict.include = [0, 0, 0.9, 0, 0];
%!   verdict.P(1 + (1:5)) = [0, [1e-5, 0.06](i), 0.9, 0, 0];
%!   [~, ~, cure] = proveCause (verdict, study, state);
%!   placebos{i} = cure.placebos;
%! end
%! [~, like] = max (study.evidence.screen.cosine(3, [1, 2, 4, 5]));
%! assert (like, 3);
%! assert ({placebos{1}.effect, placebos{2}.effect}, {'size', 'bridge'});

% SPDX-License-Identifier: GPL-3.0-only
