% FITSURROGATES  One surrogate a target from all finished runs.
%
% CALL: surrogates = fitSurrogates (data, problem)
% CALL: surrogates = fitSurrogates (data, problem, old)
%
% data        struct of newData: X n x d, Z n x T (NaN: failed)
% problem     struct of newProblem
% old         1 x T surrogates of an earlier fit: choice of trend and
%             covariance kept, only parameters estimated again (much faster);
%             chosen anew when the runs have grown by half
% surrogates  1 x T struct array of fitSurrogate
%
% Rows with effect values other than those of the first row belong to another
% model and are left out.
%
% See also: fitSurrogate, createKrigingModels

function surrogates = fitSurrogates (data, problem, old)
  if nargin < 3
    old = [];
  end
  X = data.X;
  Z = data.Z;
  if isfield (data, 'E') && ~isempty (data.E)
    same = all (data.E == data.E(1, :), 2);
    X = X(same, :);
    Z = Z(same, :);
  end
  for t = 1:numel (problem.targets)
    options = struct ('name', targetName (problem, t));
    if ~isempty (old) && sum (isfinite (Z(:, t))) < 1.5 * old(t).nChoice
      options.start = old(t);
    end
    surrogates(t) = fitSurrogate (X, Z(:, t), problem.limits, options);
  end
end

function name = targetName (problem, t)
  name = sprintf ('target_%d', t);
  if isfield (problem.targets, 'name')
    name = problem.targets(t).name;
  end
end

%!test
%! pkg load stk
%! rand ('twister', 1);
%! C = struct ('names', {{'a', 'b'}}, 'limits', [0, 0; 1, 1], ...
%!             'targets', struct ('value', {1, 2}, 'tol', 0.01));
%! problem = newProblem (C, []);
%! X = rand (10, 2);
%! data = addRows (newData (2, 2), X, [sum(X, 2), X(:, 1)], ones (10, 1), ...
%!                 'plan');
%! s = fitSurrogates (data, problem);
%! assert (size (s), [1, 2]);
%! assert (s(2).name, 'target_2');
%! assert (predictSurrogate (s, [0.5, 0.4]), [0.9, 0.5], 0.02);
%! s = fitSurrogates (data, problem, s);
%! assert (predictSurrogate (s, [0.5, 0.4]), [0.9, 0.5], 0.02);
