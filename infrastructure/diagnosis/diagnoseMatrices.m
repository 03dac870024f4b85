% DIAGNOSEMATRICES  Diagnoses a gap between simulation and measurement.
%
% CALL: [DIAGNOSIS, FURTHER] = diagnoseMatrices (GIVEN, DATA, OPTIONS, EVALUATE)
% CALL: [DIAGNOSIS, FURTHER] = diagnoseMatrices (STUDY)
%       DIAGNOSIS = FURTHER ()
%
%   GIVEN     struct of newProblem: measured values, benches, limits, effects
%   DATA      struct X (n x p), E (n x v, variables of all effects that DEM
%             runs; neutral where it is not given), Z (n x T, NaN = none),
%             replicate (n x 1; 1 where it is not given): all finished runs
%   OPTIONS   struct of gapOptions, [] = defaults
%   EVALUATE  handle Z = EVALUATE (X, E, REPLICATE) for further runs, [] = none
%             allowed; OPTIONS.maxNewRuns rows at most. One with a fourth
%             argument is told the stage: 'gap', or 'cure' for runs that verify
%             the cure. Those are no DATA of a later start, or it would verify
%             another set
%   STUDY     of studyGap, judged at its hypotheses.options.significance
%   DIAGNOSIS struct
%     options  of gapOptions;  where  of locateGap
%     fingerprint  struct: the measured gap beside the one that each candidate
%              would make, in standard deviations of the noise of a target:
%              target 1 x n (numbers of the measured ones), measured 1 x n
%              (measured less simulated without any effect), effects K x n (what
%              each effect adds where it is fitted alone, the parameters with
%              it, to the measurements that are not held out)
%     screen   of screenEffects, names (1 x K), untested (of untestedEffects)
%     which    of describeVerdict, and cause (weighCauses: what may have made it;
%              GIVEN.causes)
%     howFar   of proveCause ([] where nothing can be compared)
%     next     of adviseMeasurements, of tests that need no run
%     change   [], or with GIVEN.reference struct size, lack (1 x T'): what the
%              model is likely to miss in both conditions, simulated (1 x T'): what it
%              gives at the reference (emulateChange), sd, seen (1 x T', of the change of
%              a reading, changeOfReadings); aside (1 x m struct target, z, p: of the
%              readings that it cannot follow, see setAside); errors (strengthErrors)
%     runs     struct spent, failed, left;  data: DATA with the new runs
%     budget   see newEvaluate
%   FURTHER   [], or, where GIVEN.tests holds a handle that makes tests of other
%             benches and the verdict leaves a cause open, a handle that tries
%             them by runs: DIAGNOSIS with their place in next. The verdict does
%             not wait for them
%
% Order: WHERE, WHICH, HOW FAR, NEXT TEST. Random numbers come from
% OPTIONS.seed; the caller's random state is left as it was.
%
% Errors: those of checkMatrices, newProblem, enterRuns, strengthOfValues and fitEmulator
%
% See also: diagnoseGap, locateGap, caseEvidence, judgeCase, proveCause,
% adviseMeasurements

function [diagnosis, further] = diagnoseMatrices (given, data, options, evaluate)
  study = given;
  if nargin > 1
    if nargin < 3
      options = [];
    end
    if nargin < 4
      evaluate = [];
    end
    study = studyGap (given, data, options, evaluate);
  end
  [problem, state] = deal (study.problem, study.state);
  diagnosis.options = study.hypotheses.options;
  diagnosis.where = locateGap (study);
  [verdict, evidence] = judgeStudy (study, diagnosis.where.side);
  diagnosis.screen = evidence.screen;
  diagnosis.screen.names = study.hypotheses.names;
  diagnosis.screen.untested = untestedEffects (study.untested, problem.effects, state);
  diagnosis.fingerprint = fingerprints (study);
  study.evidence = evidence;
  [verdict, evidence, diagnosis.howFar, state] = proveCause (verdict, study, state);
  verdict = withoutReadings (verdict, study);
  verdict = doubtName (verdict, diagnosis, study.hypotheses);
  diagnosis.which = describeVerdict (evidence, verdict, study.hypotheses, problem);
  diagnosis.which.strength = asFitted (diagnosis.which.strength, diagnosis.howFar, ...
                                       problem.effects);
  diagnosis.which.cause = causesOfVerdict (verdict, study);
  [diagnosis.next, trials] = adviseMeasurements (study, evidence, verdict, state);
  diagnosis.change = [];
  if ~isempty (study.emulator.change)
    change = study.emulator.change;
    [~, sd, seen] = changeOfReadings (problem, change);
    diagnosis.change = struct ('size', change.size, ...
                               'lack', change.lack .* problem.unit, ...
                               'simulated', change.simulated .* problem.unit, ...
                               'sd', sd .* problem.unit, 'seen', seen .* problem.unit, ...
                               'aside', asideOf (problem, change), ...
                               'errors', strengthErrors (study, evidence));
  end
  diagnosis = inGivenUnits (diagnosis, problem);
  diagnosis = withRuns (diagnosis, state, study.known);
  diagnosis.data = withNewRuns (study.data, state, study.state.data, problem);
  further = [];
  if ~isempty (trials)
    further = @() withTests (diagnosis, trials, study.known);
  end
end

% What has changed in the readings that the model cannot follow: by the measurements
% alone. p: chance that noise changes any of them so much.
function list = asideOf (problem, change)
  at = find (problem.aside);
  [p, sd] = changeOfReadings (problem, change);
  z = (problem.value - problem.reference.value) ./ sd;
  list = struct ('target', num2cell (at), 'z', num2cell (z(at)), ...
                 'p', num2cell (min (numel (at) * p(at), 1)));
end

% One number for a thing: where a cause was fitted together with the parameters, its
% strength there is said, as the head of a model gets it; the interval stays that of
% all that would do.
function strength = asFitted (strength, cure, effects)
  if isempty (cure)
    return
  end
  names = strsplit (cure.effect, ' + ');
  for k = 1:numel (names)
    at = find (strcmp ({strength.name}, names{k}));
    e = effects(strcmp ({effects.name}, names{k}));
    phi = cure.phi(k);
    if isempty (at) || any (phi < strength(at).interval90(1)) || ...
       any (phi > strength(at).interval90(2))
      continue
    end
    strength(at).values(1, :) = e.strongest * phi;
    if ~e.laboratory
      strength(at).values(1, :) = valuesOfStrength (e, phi);
    end
  end
end

function diagnosis = withTests (diagnosis, trials, known)
  [diagnosis.next, state] = trials ();
  diagnosis = withRuns (diagnosis, state, known);
end

function diagnosis = withRuns (diagnosis, state, known)
  diagnosis.runs = runsMade (state, known);
  diagnosis.runs.left = state.budget.sets;
  diagnosis.budget = state.budget;
end

% Where two rows look alike, the two causes do.
function prints = fingerprints (study)
  problem = study.problem;
  emulator = study.emulator;
  at = sort ([problem.used, problem.heldOut]);
  sd = sqrt (diag (noiseBudget (problem, emulator).covariance))';
  without = predictGap (emulator, [], study.fits.calibrated.Q(1, :));
  K = numel (study.hypotheses.names);
  prints = struct ('target', at, 'measured', ...
                   (problem.value(at) - without(at)) ./ sd(at), ...
                   'effects', zeros (K, numel (at)));
  for k = 1:K
    with = predictGap (emulator, k, fitCure (study, k));
    prints.effects(k, :) = (with(at) - without(at)) ./ sd(at);
  end
end

% Back through the door of enterRuns.
function diagnosis = inGivenUnits (diagnosis, problem)
  unit = problem.unit;
  own = unit(problem.used);
  where = diagnosis.where;
  where.residual = where.residual .* own;
  where.sd = where.sd .* own;
  where.held.mean = where.held.mean .* unit(problem.heldOut);
  where.held.sd = where.held.sd .* unit(problem.heldOut);
  for name = {'measurement', 'trial', 'noiseSd', 'surrogate'}
    where.budget.(name{1}) = where.budget.(name{1}) .* unit;
  end
  for name = {'estimated', 'unknown', 'own'}
    where.budget.(name{1}) = where.budget.(name{1}) .* unit.^2;
  end
  where.budget.doubt = where.budget.doubt .* unit.^4;
  where.budget.covariance = where.budget.covariance .* (unit' * unit);
  where.out = problem.out;
  where.neverRun = problem.neverRun;
  where.lacking = problem.lacking;
  diagnosis.where = where;
  if ~isempty (diagnosis.howFar)
    for i = 1:numel (diagnosis.howFar.targets)
      one = diagnosis.howFar.targets(i);
      for name = {'before', 'after', 'sdBefore', 'sd'}
        one.(name{1}) = one.(name{1}) * unit(one.target);
      end
      diagnosis.howFar.targets(i) = one;
    end
  end
  diagnosis.problem = inUnits (problem, 1 ./ unit);
end

% A name does not stand where the effect's runs contradict their surrogate, or
% where DEM runs with it still miss a target.
function verdict = doubtName (verdict, diagnosis, hypotheses)
  if ~strcmp (verdict.kind, 'named')
    return
  end
  names = hypotheses.names(verdict.effects);
  far = diagnosis.howFar;
  if any (ismember (names, diagnosis.where.side.poorEffects))
    verdict.guard = 'surrogate';
    verdict.reason = sprintf ('the runs of %s contradict their surrogate', ...
                              strjoin (names, ' and '));
  elseif ~isempty (far) && far.stillMisses
    verdict.guard = 'cure';
    verdict.reason = sprintf (['DEM runs with %s still miss a target by ' ...
                               '%.1f standard deviations'], ...
                              strjoin (names, ' and '), ...
                              max (abs (far.remaining)));
  else
    return
  end
  verdict.kind = 'group';
  verdict.lookAlike = true;
end

%!test
%! % no more measured values than parameters: a verdict, not an error
%! [given, data] = smallGapLab ();
%! given.value = NaN (1, 12);
%! given.value([2, 7]) = mean (data.Z)([2, 7]) + 1;
%! d = diagnoseMatrices (given, data, struct ('bootstrap', 49, 'twins', 60));
%! assert (any (strcmp (d.which.verdict, {'no gap', 'undecided'})));

% SPDX-License-Identifier: GPL-3.0-only
