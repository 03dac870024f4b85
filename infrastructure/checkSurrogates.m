% CHECKSURROGATES  Plain warnings about a calibration, one sentence each.
%
% CALL: lines = checkSurrogates (state, problem)
%
% state    struct of newState
% problem  struct of newProblem
% lines    cellstr: a target outside the range of the responses, a surrogate
%          with poor Q2, a parameter at its limit, fewer targets than
%          parameters, runs that failed
%
% See also: limitsTouched, findConflict

function lines = checkSurrogates (state, problem)
  lines = {};
  for t = 1:numel (state.surrogates)
    s = state.surrogates(t);
    low = min (s.z);
    high = max (s.z);
    if problem.value(t) < low || problem.value(t) > high
      lines{end + 1} = sprintf (['target %s = %g lies outside what the ' ...
                                 'runs reached (%g to %g)'], s.name, ...
                                problem.value(t), low, high);
    end
    if ~isempty (s.warning)
      lines{end + 1} = sprintf ('%s: %s', s.name, s.warning);
    end
  end
  touched = limitsTouched (state.found.params, problem);
  if ~isempty (touched)
    lines{end + 1} = ['at a limit of the box: ', strjoin(touched, ', ')];
  end
  nTargets = sum (problem.calibrate);
  d = numel (problem.names);
  if nTargets < d
    lines{end + 1} = sprintf (['%d targets cannot fix %d parameters: other ' ...
                               'sets meet them as well'], nTargets, d);
  end
  failed = sum (any (isnan (state.data.Z), 2));
  if failed > 0
    lines{end + 1} = sprintf ('%d of %d runs failed and are left out', ...
                              failed, rows (state.data.Z));
  end
end
