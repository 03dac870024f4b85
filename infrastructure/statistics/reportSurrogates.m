% REPORTSURROGATES  One line of text a surrogate.
%
% CALL: lines = reportSurrogates (surrogates)
%
% surrogates  1 x T struct array of fitSurrogates
% lines       cellstr: name, leave-one-out Q2, noise of a run, trend, covariance
%
% See also: fitSurrogates, checkSurrogates

function lines = reportSurrogates (surrogates)
  lines = cell (1, numel (surrogates));
  for t = 1:numel (surrogates)
    s = surrogates(t);
    lines{t} = sprintf (['%-20s Q2 %5.3f   noise of a run %.3g (%.2g %%)   ' ...
                         'largest standardised residual %.1f   %s, %s'], ...
                        s.name, s.Q2, sqrt (s.noiseVar), ...
                        100 * sqrt (s.noiseVar) / abs (mean (s.z)), ...
                        max (abs (s.looStd)), s.trend, s.covariance);
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
%! lines = reportSurrogates (s);
%! assert (size (lines), [1, 2]);
%! assert (strncmp (lines{1}, 'x ', 2));
%! assert (~isempty (strfind (lines{2}, sprintf ('Q2 %5.3f', s(2).Q2))));
