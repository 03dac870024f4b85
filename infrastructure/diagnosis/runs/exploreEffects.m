% EXPLOREEFFECTS  Runs candidate effects until it is clear which one it is.
%
% CALL: [STATE, EMULATOR] = exploreEffects (PROBLEM, OPTIONS, STATE, EMULATOR)
%
%   PROBLEM, OPTIONS     of newProblem, gapOptions
%   STATE                of newGapState
%   EMULATOR             of fitEmulator, fitted to STATE.data
%
% First every effect that has no such run yet once at full strength at the
% fitted null model, both ends where it acts both ways; one that gives no result
% there at half, a quarter and an eighth of it. Then, where it is in doubt
% whether there is a gap, neutral sets near the null model (runsToSeek). If
% there is one, batches of OPTIONS.batch runs (proposeRuns), until the verdict
% stands or the next batch would tell next to nothing (OPTIONS.worthAt). Runs
% that verify the cure are set aside before. Nothing is run without
% STATE.evaluate. In a case with levels the runs of effects are of the first
% one, but for those at a mode. A second start finds these runs; it makes others
% only where the first one ended because OPTIONS.maxNewRuns was spent.

function [state, emulator] = exploreEffects (problem, options, state, emulator)
  if isempty (state.evaluate) || state.budget.sets < 1 || isempty (emulator.effect)
    return
  end
  reserve = min (4 * options.verifyRuns, floor (state.budget.sets / 3));
  state.budget.sets = state.budget.sets - reserve;
  theta = calibrateNull (problem, emulator, options);
  state = runEach (problem, state, theta);
  emulator = emulate (problem, state.data, options, emulator);
  reference = [];
  while state.budget.sets > 0
    [now, reference] = weighNow (problem, options, emulator, reference);
    if isempty (now)
      break
    end
    theta = now.fits.calibrated.Q;
    n = runsToSeek (problem, options, emulator.base, theta, now.evidence.gate.p);
    if n > 0
      state = runNearNull (problem, state, theta, n, 0.5, ...
                           options.seed + rows (state.data.X));
      % what the gate compares with is another one then
      reference = [];
    elseif now.evidence.gate.p > 2 * options.significance || stands (now, options)
      break
    else
      batch = proposeRuns (problem, options, state, emulator, now);
      if batch.bits < options.worthAt
        break
      end
      state = runBatch (problem, state, batch);
    end
    emulator = emulate (problem, state.data, options, emulator);
  end
  state.budget.sets = state.budget.sets + reserve;
  % not from what the runs before told: as a second start fits it
  emulator = emulate (problem, state.data, options);
end

% Neither a gap nor none: surrogates that few runs have told hide one, but not
% that of a change, whose reference knows them better. Counted are the neutral
% sets that lie near THETA, whoever asked for them.
function n = runsToSeek (problem, options, base, theta, p)
  n = 0;
  if p < options.significance || p >= options.seekAt || ...
     ~isempty (problem.reference)
    return
  end
  isNear = all (abs (base.theta - theta) < 0.5, 2) & isFine (base);
  n = max (min (options.batch, options.seekRuns - sum (isNear)), 0);
end

% What is known now, roughly; [] where nothing can be told.
% Some runs more hardly change what the gate compares with: it is drawn once.
function [now, reference] = weighNow (problem, options, emulator, reference)
  now = [];
  usable = find ([emulator.effect.laboratory] | [emulator.effect.runs] >= 1);
  if isempty (usable)
    return
  end
  library = withoutEffects (emulator, setdiff (1:numel (emulator.effect), usable));
  options.twins = min (options.twins, 59);
  [options.points, options.effective, options.most] = deal (300, 100, 2000);
  hypotheses = makeHypotheses (problem, library, options);
  fits = fitLibrary (hypotheses, problem.value(problem.used));
  if isempty (reference)
    hypotheses = gapReference (hypotheses);
    reference = hypotheses.reference;
  end
  hypotheses.reference = reference;
  evidence = caseEvidence (hypotheses, fits, 1);
  now = struct ('evidence', evidence, 'verdict', judgeCase (evidence, hypotheses), ...
                'hypotheses', hypotheses, 'fits', fits, 'usable', usable);
  now.runs = [library.effect.runs];
  now.tried = arrayfun (@(e) rows (e.Q), library.effect);
  isLaboratory = [library.effect.laboratory];
  [now.runs(isLaboratory), now.tried(isLaboratory)] = deal (Inf);
  now.isVague = vagueShare (now, now.verdict.top) >= options.vagueAt;
  now.alike = alikeTwo (evidence.screen, now.verdict.top, options.alikeAt);
  now.rivals = rivalsOf (now, options);
end

% Effects that the data do not part yet, and whose marks are known too badly
% where they fit to part them: the better emulated one would win. [] where there
% is nothing to part.
function rivals = rivalsOf (now, options)
  top = now.verdict.top;
  near = natsBehind (now.evidence, now.verdict, top) <= options.classNats;
  isOpen = now.evidence.vague > options.vagueRun & now.runs < options.mostRuns;
  near(top) = any (near);
  rivals = find (near & isOpen);
end

% The likeliest effect and the one most like it, if any is ([]: none): with few
% runs its mark could be anything, and it is unlikely for that alone. One that
% does the opposite, and cannot do it the other way round, is none.
function two = alikeTwo (screen, top, least)
  cosine = screen.cosine(top, :);
  cosine(top) = 0;
  [most, rival] = max (cosine);
  two = [top(most >= least), rival(most >= least)];
end

% The likeliest effect is likely enough, it and the next likely one have been
% run often enough to believe it, it and one much like it so often that their
% bends are known, its mark is known better than the rest, and those of the
% effects that are not parted from it, too.
function yes = stands (now, options)
  [total, order] = sort (-now.verdict.include);
  two = order(1:min (2, numel (order)));
  yes = -total(1) >= options.standsAt && isempty (now.rivals) && ...
        all (now.runs(two) >= options.standsRuns) && ...
        all (now.tried(now.alike) >= options.alikeRuns) && ...
        (now.runs(two(1)) >= options.mostRuns || ~now.isVague);
end

% Share of the variance of a target that comes with effect K where it fits best.
function share = vagueShare (now, k)
  white = now.hypotheses.white;
  fit = now.fits.of{now.hypotheses.singles(k)};
  [~, with] = predictGap (white, k, fit.Q(1, 1:white.p + 1));
  [~, without] = predictGap (white, [], now.fits.calibrated.Q(1, 1:white.p));
  share = 1 - mean (min (without ./ with, 1));
end

%!function [given, data, run] = laboratory (strength)
%!  pkg load stk
%!  [given, data, means] = smallGapLab ();
%!  data = keepRows (data, all (data.E == 0, 2));
%!  effects = newProblem (setfield (given, 'value', ones (1, 12))).effects;
%!  run = @(X, E, varargin) means (X, strengthOfValues (effects, E)) + ...
%!                          0.2 * randn (rows (X), 12);
%!  randn ('twister', 3);
%!  given.value = means ([0.4, 0.6], strength) + 0.2 * randn (1, 12);
%!endfunction
%!function [state, emulator] = explored (given, data, run, more = struct ())
%!  options = gapOptions (mergeFields (struct ('trend', 'affine', ...
%!                                             'maxNewRuns', 60), more));
%!  problem = setfield (newProblem (given), 'unit', ones (1, 12));
%!  state = newGapState (data, options, run);
%!  emulator = fitEmulator (problem, data, options);
%!  [state, emulator] = exploreEffects (problem, options, state, ...
%!                                emulateChange (emulator, problem));
%!endfunction
%!test
%! % no gap: each effect once
%! [given, data, run] = laboratory (zeros (1, 5));
%! state = explored (given, data, run);
%! assert (state.budget.new, 4);

% SPDX-License-Identifier: GPL-3.0-only
