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
  own = isOwn (state.data);
  failed = sum (any (isnan (state.data.Z(own, :)), 2));
  if failed > 0
    lines{end + 1} = sprintf ('%d of %d runs failed and are left out', ...
                              failed, sum (own));
  end
end

%!shared problem, state, s
%! pkg load stk
%! pkg load -nodeps struct optim
%! rand ('twister', 2);
%! randn ('twister', 2);
%! C = struct ('names', {{'a', 'b'}}, 'limits', [0, 0; 1, 2]);
%! C.targets = struct ('name', {'x', 'y'}, 'value', {4, 2}, 'tol', 0.02);
%! problem = newProblem (C, []);
%! X = rand (12, 2) .* [1, 2];
%! Z = [3 + X(:, 1) + X(:, 2) / 2, 1 + X(:, 1) + X(:, 2) / 2.5];
%! data = addRows (newData (2, 2), X, Z .* (1 + 0.003 * randn (12, 2)), ...
%!                 ones (12, 1), 'plan');
%! s = fitSurrogates (data, problem);
%! state = newState (data, s, describeSet (s, problem, [0.5, 1]));
%! state.found.conflict = {};

%!test
%! lines = checkSurrogates (state, problem);
%! assert (isempty (lines));
%! problem.value(2) = 9;
%! problem.calibrate(1) = false;
%! state.found.params = [1, 1];
%! state.data.Z(3, 1) = NaN;
%! lines = checkSurrogates (state, problem);
%! assert (numel (lines), 4);
%! assert (lines{1}, ['target y = 9 lies outside what the runs reached ', ...
%!                    sprintf('(%g to %g)', min (s(2).z), max (s(2).z))]);
%! assert (lines{2}, 'at a limit of the box: a');
