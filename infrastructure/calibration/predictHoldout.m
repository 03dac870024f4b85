% PREDICTHOLDOUT  Held-out targets against what the found set predicts.
%
% CALL: HOLD = predictHoldout (STATE, PROBLEM)
%
% STATE  struct of newState; PROBLEM  struct of newProblem
% HOLD   1 x h struct array: name, target, result (prediction of the mean
%        response), sd (of the prediction error), interval90 2 x 1 (where a
%        measurement should lie), inside (logical; NaN: not measured yet)
%
% The prediction error holds the variance of the surrogate at the set, the
% scatter of one run (the experiment is one packing, too, or the mean of so many
% trials) and the measurement uncertainty of the target.

function hold = predictHoldout (state, problem)
  hold = struct ('name', {}, 'target', {}, 'result', {}, 'sd', {}, ...
                 'interval90', {}, 'inside', {});
  [m, v] = predictSurrogate (state.surrogates, state.found.params);
  for t = find (~problem.calibrate)
    s = state.surrogates(t);
    sd = sqrt (v(t) + s.noiseVar / problem.trials(t) + problem.sd(t)^2);
    half = studentQuantile (0.95, s.df) * sd;
    hold(end + 1) = struct ('name', s.name, 'target', problem.value(t), ...
                            'result', m(t), 'sd', sd, ...
                            'interval90', [m(t) - half; m(t) + half], ...
                            'inside', abs (problem.value(t) - m(t)) <= half);
    if isnan (problem.value(t))
      hold(end).inside = NaN;
    end
  end
end

%!test
%! pkg load stk
%! rand ('twister', 1);
%! randn ('twister', 1);
%! C = struct ('names', {{'a'}}, 'limits', [0; 1], ...
%!             'targets', struct ('value', {1.5, 2}, 'tol', 0.05, ...
%!                                'role', {'calibrate', 'holdout'}));
%! problem = newProblem (C, []);
%! X = rand (12, 1);
%! Z = [1 + X, 1 + 2 * X] + 0.02 * randn (12, 2);
%! data = addRows (newData (1, 2), X, Z, ones (12, 1), 'plan');
%! state = newState (data, fitSurrogates (data, problem), ...
%!                   struct ('params', 0.5));
%! hold = predictHoldout (state, problem);
%! assert (hold.result, 2, 0.05);
%! assert (hold.inside);
%! problem.value(2) = 3;
%! assert (~ predictHoldout (state, problem).inside);
%! state.found = describeSet (state.surrogates, problem, 0.5);
%! lines = checkSurrogates (state, problem);
%! assert (any (strncmp (lines, 'target target_2', 15)));
