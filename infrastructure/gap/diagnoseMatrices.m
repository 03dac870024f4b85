% DIAGNOSEMATRICES  Diagnoses a gap between simulation and measurement.
%
% CALL: DIAGNOSIS = diagnoseMatrices (GIVEN, DATA, OPTIONS, EVALUATE)
%
%   GIVEN     struct of newGapProblem: measured values, benches, limits, effects
%   DATA      struct X (n x p), E (n x v, variables of all effects that DEM
%             runs), Z (n x T, NaN = none), replicate (n x 1): all finished runs
%   OPTIONS   struct of gapOptions, [] = defaults
%   EVALUATE  handle Z = EVALUATE (X, E, REPLICATE) for further runs, [] = none
%             allowed; OPTIONS.maxNewRuns rows at most. One with a fourth
%             argument is told the stage: 'gap', or 'cure' for runs that verify
%             the cure. Those are no DATA of a later start, or it would verify
%             another set
%   DIAGNOSIS struct
%     where    of locateGap
%     screen   of screenEffects, names (1 x K), untested (cellstr, no runs)
%     which    verdict, reason, effects (cellstr), posterior (struct null, each
%              effect, unlisted), likely, cannotSee, groups, strength (1 x m
%              struct name, value, interval90, range), priorSpread (change of
%              the first probability when prior scales are halved or doubled),
%              expected (calibrateVerdict), numbers (error, ess: of integrals)
%     howFar   of measureCure ([] where nothing can be compared)
%     next     of nextTest
%     runs     struct spent, failed, left;  data: DATA with the new runs
%
% Order: WHERE, WHICH, HOW FAR, NEXT TEST. Random numbers come from
% OPTIONS.seed; the caller's random state is left as it was.
%
% Errors: those of newGapProblem, effectStrength and fitEmulator
%
% See also: diagnoseGap, locateGap, weighCase, judgeCase, measureCure, nextTest

function diagnosis = diagnoseMatrices (given, data, options, evaluate)
  if nargin < 3
    options = [];
  end
  if nargin < 4
    evaluate = [];
  end
  problem = newGapProblem (given);
  options = gapOptions (options);
  state = struct ('data', data, 'evaluate', evaluate, 'spent', 0, ...
                  'failed', 0, 'left', options.maxNewRuns, ...
                  'repeats', options.verifyRuns);
  [state, em] = improveSurrogates (problem, options, state);
  [state, em] = exploreEffects (problem, options, state, em);
  kept = tested (em);
  library = em;
  library.effect = em.effect(kept);
  models = makeModels (problem, library, options);
  fits = fitLibrary (models, problem.y(problem.used));
  diagnosis.where = locateGap (problem, em, models, fits, options);
  [models, expected] = calibrateVerdict (problem, library, models, options);
  w = weighCase (models, fits, 1, true);
  verdict = judgeCase (w, models);
  if diagnosis.where.side.blameSurrogate
    verdict.kind = 'surrogate';
    verdict.effects = [];
    verdict.reason = diagnosis.where.side.reason;
  end
  diagnosis.screen = w.screen;
  diagnosis.screen.names = models.names;
  diagnosis.screen.untested = {em.effect(~kept).name};
  diagnosis.which = describeVerdict (w, verdict, models, problem);
  diagnosis.which.expected = expected;
  causes = comparedCauses (w, verdict);
  diagnosis.howFar = [];
  if ~isempty (causes)
    state = pauseRuns (state, verdict.kind);
    view = struct ('problem', problem, 'em', library, 'models', models, ...
                   'fits', fits);
    [diagnosis.howFar, state] = measureCure (view, causes, state);
  end
  diagnosis.next = nextTest (problem, library, w, verdict.P);
  diagnosis.problem = problem;
  diagnosis.runs = struct ('spent', state.spent, 'failed', state.failed, ...
                           'left', state.left);
  diagnosis.data = state.data;
end

function kept = tested (em)
  kept = [em.effect.laboratory] | [em.effect.runs] >= 3;
end

% Only a cause that is named is worth DEM runs.
function state = pauseRuns (state, kind)
  if ~any (strcmp (kind, {'named', 'group'}))
    state.evaluate = [];
  end
end

function causes = comparedCauses (w, verdict)
  causes = {};
  if isempty (verdict.include) || strcmp (verdict.kind, 'surrogate')
    return
  end
  [~, order] = sort (-verdict.include);
  first = verdict.top;
  if strcmp (verdict.kind, 'named')
    first = verdict.effects;
  end
  others = order(~ismember (order, first));
  causes = [{first}, num2cell(others(1:min (2, numel (others))))];
end

% Where the surrogates are to blame, runs near the fitted set come first.
function [state, em] = improveSurrogates (problem, options, state)
  for round_ = 1:3
    em = fitEmulator (problem, state.data, options);
    models = makeModels (problem, withoutEffects (em, 1:numel (em.effect)), ...
                         options);
    fits = fitLibrary (models, problem.y(problem.used));
    theta = fits.null.Q(1, :);
    side = sideSignals (problem, em, theta);
    n = min (2 * em.p + 2, floor (state.left / 2));
    if ~side.blameSurrogate || round_ == 3 || n < 1 || isempty (state.evaluate)
      return
    end
    spread = integrationPoints (n, em.p, options.seed + round_).uniform - 0.5;
    near = min (max (theta + 0.8 / round_ * spread, -1), 1);
    state = spendRuns (state, problem, near, ...
                       zeros (n, numel (problem.effects)), ones (n, 1));
  end
end
