% NEWCALIBRATION  Sums a finished calibration up.
%
% CALL: C = newCalibration (STATE, PROBLEM, CASE)
%
%   STATE    see newState, with its field final
%   PROBLEM  see newProblem
%   CASE     see newCase
%   C        scalar struct: params 1 x d, results 1 x T, residual T x 1,
%            noiseSd 1 x T (noise of one run), runs at the set, interval90
%            2 x d, converged, reason, limit, conflict, met,
%            estimate (see confirmSet), untested (handBack),
%            demRuns, coreSeconds, atLimit,
%            notIdentified, identifiability (see there), correlation d x d,
%            sensitivity d x T (total Sobol indices), warnings,
%            holdout, levels (see describeLevels), surrogates, history, data,
%            exitStatus;
%            resultInterval90 2 x T (of the mean response at the set),
%            probability (that all targets are met), posterior (n x d, sample)

function c = newCalibration (state, problem, Case)
  final = state.final;
  known = parameterPosterior (state.surrogates, problem);
  weak = identifiability (state.surrogates, problem, known);
  M = numel (Case.models);
  stages = state.data.stage;
  count = @(varargin) M * sum (ismember (stages, varargin));
  c = struct ('params', final.params, 'results', final.result, ...
              'residual', final.residual, 'noiseSd', final.noiseSd, ...
              'runs', final.n, 'interval90', known.interval90, ...
              'converged', final.converged, 'reason', final.reason);
  c.limit = final.limit;
  c.conflict = final.conflict;
  c.met = final.met;
  c.estimate = final.estimate;
  c.untested = final.untested;
  c.resultInterval90 = final.interval90;
  c.probability = final.probability;
  c.posterior = known.sample;
  c.demRuns = struct ('plan', count ('plan'), 'infill', count ('infill'), ...
                      'verify', count ('verify', 'replicate'), ...
                      'failed', state.budget.failed, ...
                      'reused', state.budget.reused);
  c.coreSeconds = state.budget.coreSeconds;
  [c.warnings, c.atLimit] = checkSurrogates (state, problem);
  c.notIdentified = weak.notIdentified;
  c.identifiability = weak;
  c.correlation = known.correlation;
  c.sensitivity = sobolIndices (state.surrogates, problem).total;
  c.holdout = [];
  if any (~problem.calibrate)
    c.holdout = predictHoldout (state, problem);
  end
  c.levels = describeLevels (state, problem);
  c.surrogates = state.surrogates;
  c.history = state.history;
  c.data = state.data;
  c.exitStatus = 2 * ~final.converged;
end
