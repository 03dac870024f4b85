% FITSURROGATES  One surrogate a target from all finished runs.
%
% CALL: SURROGATES = fitSurrogates (DATA, PROBLEM)
% CALL: SURROGATES = fitSurrogates (DATA, PROBLEM, OLD)
%
% DATA        struct of newData: X n x d, Z n x T (NaN: failed)
% PROBLEM     struct of newProblem
% OLD         1 x T surrogates of an earlier fit: choice of trend and
%             covariance kept, only parameters estimated again (much faster);
%             chosen anew when the runs have grown by a fifth
% SURROGATES  1 x T struct array of fitSurrogate
%
% Rows with effect values other than those of the first row belong to another
% model and are left out.
%
% Runs that are off by far more than runs scatter are left out (findBadRuns);
% leftOut (n x 1 logical, rows of DATA) says which. Not judged where the scatter
% is known to follow the response, for there a wide run may be a good one.
%
% The noise is estimated with each fit. Where 8 and more degrees of freedom of
% replicates show that the scatter follows the response (estimateNoise), each
% row has its own variance, and noiseVar is that at the target.
%
% See also: fitSurrogate, findBadRuns, estimateNoise, createKrigingModels

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
  bad = false (size (Z));
  if ~isempty (old) && ~isempty (old(1).leftOut)
    known = horzcat (old.leftOut);
    bad(1:rows (known), :) = known;
  end
  [surrogates, follows] = fitGood (X, Z, bad, problem, old);
  if ~follows
    now = findBadRuns (X, Z, modelOfTarget (problem), surrogates, bad);
    if ~isequal (now, bad)
      surrogates = fitGood (X, Z, now, problem, []);
      bad = now;
    end
  end
  for t = 1:numel (surrogates)
    surrogates(t).leftOut = bad(:, t);
  end
end

function [surrogates, anyFollows] = fitGood (X, Z, bad, problem, old)
  Z(bad) = NaN;
  noise = estimateNoise (struct ('X', X, 'Z', Z), problem);
  anyFollows = false;
  for t = 1:numel (problem.targets)
    options = struct ('name', targetName (problem, t));
    if ~isempty (old) && sum (isfinite (Z(:, t))) < 1.2 * old(t).nChoice
      options.start = old(t);
    end
    follows = noise.heteroscedastic(t) && noise.df(t) >= 8;
    if follows
      options.noise = noise.varianceAt{t}(Z(isfinite (Z(:, t)), t));
      anyFollows = true;
    end
    surrogates(t) = fitSurrogate (X, Z(:, t), problem.limits, options);
    if follows
      level = problem.value(t);
      if isnan (level)
        % not measured yet: where the runs are
        level = median (Z(isfinite (Z(:, t)), t));
      end
      surrogates(t).noiseVar = noise.varianceAt{t}(level);
    end
  end
end

function model = modelOfTarget (problem)
  model = ones (1, numel (problem.targets));
  if isfield (problem.targets, 'model')
    model = [problem.targets.model];
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

%!test
%! % scatter in proportion to the response (12 sets of 4 runs)
%! rand ('twister', 1);
%! randn ('twister', 1);
%! X = kron (rand (12, 1), ones (4, 1));
%! Z = (1 + 9 * X) .* (1 + 0.05 * randn (48, 1));
%! C = struct ('names', {{'a'}}, 'limits', [0; 1], ...
%!             'targets', struct ('value', 2, 'tol', 0.01));
%! data = addRows (newData (1, 1), X, Z, ones (48, 1), 'plan');
%! s = fitSurrogates (data, newProblem (C, []));
%! assert (sqrt (s.noiseVar), 0.1, 0.04);
%! assert (numel (s.model.lognoisevariance), 48);
