% FITSURROGATES  One surrogate a target from all finished runs.
%
% CALL: SURROGATES = fitSurrogates (DATA, PROBLEM)
% CALL: SURROGATES = fitSurrogates (DATA, PROBLEM, OLD, MOST)
%
% DATA        struct of newData: X n x d, Z n x T (NaN: failed), E n x v
% PROBLEM     struct of newProblem
% OLD         1 x T surrogates of an earlier fit: their trend and covariance are
%             kept (much faster) until the runs have grown by a fifth
% MOST        runs that are fitted at most (2000), chosen by thinRuns: memory
% SURROGATES  1 x T struct array of fitSurrogate
%
% Rows with effect values other than those of the first row belong to another
% model and are left out. Not so where E holds the levels of PROBLEM.coarse:
% then the level is one more input of the surrogate (fitLevels), unless the runs
% are all of one level. Equal replicates count as one run (countEqualOnce).
%
% With options.method 'published' of PROBLEM the trend is affine, the covariance
% stk_materncov_aniso without a prior, and every run counts.
%
% Runs that are off by far more than runs scatter, and than another run of their
% set, are left out (findBadRuns): leftOut (n x 1 logical, rows of DATA) says
% which, aside (k x 1) what they gave, suspect (n x 1 logical) which would be if
% the set were run once more. A target does not judge where replicates show that
% its scatter follows the response (estimateNoise), for there a wide run may be a
% good one: each row has its own variance then, and noiseVar is that at the
% target.
%
% The variance of a prediction holds what the parameters of the surrogates leave
% open (parameterSpread).
%
% With the field form of PROBLEM (1 x T struct array, see fitSurrogate) trend,
% ranges, bends and noise of the responses are known beforehand: no run is
% judged then, and nothing but the runs is open.

function surrogates = fitSurrogates (data, problem, old, most)
  if nargin < 3
    old = [];
  end
  if nargin < 4
    most = 2000;
  end
  data.Z = countEqualOnce (data, problem.bench);
  same = rowsToFit (data, problem, most);
  level = levelsOf (data.E(same, :), data.Z(same, :), problem);
  [leftOut, suspect] = deal (false (size (data.Z)));
  if ~isempty (old) && ~isempty (old(1).leftOut)
    known = horzcat (old.leftOut);
    leftOut(1:rows (known), :) = known;
  end
  runs = struct ('X', data.X(same, :), 'Z', data.Z(same, :), 'extra', {level});
  bad = leftOut(same, :);
  form = givenField (problem, 'form', []);
  [surrogates, follows] = fitGood (runs, bad, problem, old);
  kind = kindOfTarget (problem);
  kind.judges = kind.judges & ~follows;
  if any (kind.judges)
    [now, doubt] = findBadRuns (withoutDropped (runs, surrogates), ...
                                kind, surrogates, bad);
    suspect(same, :) = doubt;
    if ~isequal (now, bad)
      surrogates = fitGood (runs, now, problem, []);
      bad = now;
    end
  end
  leftOut(same, :) = bad;
  for t = 1:numel (surrogates)
    surrogates(t).leftOut = leftOut(:, t);
    surrogates(t).suspect = suspect(:, t);
    surrogates(t).aside = data.Z(any (leftOut, 2), t);
    if isempty (form) && ~surrogates(t).published
      surrogates(t).solver.open = parameterSpread (surrogates(t));
    end
  end
end

% Those of one model, and no more than memory holds.
function same = rowsToFit (data, problem, most)
  same = true (rows (data.X), 1);
  if isempty (problem.coarse) && ~isempty (data.E)
    same = all (data.E == data.E(1, :), 2);
  end
  if sum (same) > most
    table = struct ('X', data.X(same, :), 'E', data.E(same, :), ...
                    'Z', data.Z(same, :));
    same(same) = thinRuns (table, problem, most);
  end
end

% How coarse the runs are, for each target; [] where it makes no difference, or
% none can be seen as all finished runs are of one level.
function level = levelsOf (E, Z, problem)
  level = cell (1, columns (Z));
  if isempty (problem.coarse)
    return
  end
  for t = 1:numel (level)
    coarseness = unitLevel (problem.coarse, E, t);
    if any (coarseness) && numel (unique (coarseness(isfinite (Z(:, t))))) > 1
      level{t} = coarseness;
    end
  end
end

function runs = withoutDropped (runs, surrogates)
  for t = find (~cellfun (@isempty, {surrogates.dropped}))
    isDropped = ismember (runs.extra{t}, surrogates(t).dropped);
    runs.Z(isDropped, t) = NaN;
  end
end

function [surrogates, follows] = fitGood (runs, bad, problem, old)
  X = runs.X;
  Z = runs.Z;
  Z(bad) = NaN;
  law = estimateNoise (X, Z);
  form = givenField (problem, 'form', []);
  shape = givenField (problem, 'shape', {});
  if ~isempty (form)
    law = {form.noise};
  end
  isPublished = strcmp (problem.options.method, 'published');
  if isPublished
    law(:) = {[]};
  end
  % published: every run counts
  follows = repmat (isPublished, 1, numel (problem.value));
  for t = 1:numel (problem.value)
    options = struct ('name', problem.targetNames{t}, 'unit', ...
                      problem.tol(t) * abs (problem.scale(t)));
    if ~isempty (problem.prior)
      options.prior = problem.prior{t};
    end
    options.form = ofTarget (form, t);
    if ~isempty (shape)
      options.shape = shape{t};
    end
    options.quick = ~isempty (old);
    if problem.earlierRuns(t) > 0
      options.scatter = [problem.earlierSd(t), problem.earlierRuns(t)];
    end
    if isPublished
      options.trend = 'affine';
      options.covariance = 'matern';
      options.published = true;
      options.shape = [];
    end
    if ~isempty (old) && sum (isfinite (Z(:, t))) < 1.2 * old(t).nChoice
      options.start = old(t);
    end
    if ~isempty (runs.extra{t})
      s = fitLevels (X, Z(:, t), runs.extra{t}, problem.limits, options);
    elseif isempty (law{t})
      s = fitSurrogate (X, Z(:, t), problem.limits, options);
    else
      known = Z(isfinite (Z(:, t)), t);
      options.noise = law{t}(known);
      follows(t) = true;
      s = fitSurrogate (X, Z(:, t), problem.limits, options);
      % not measured yet: where the runs are
      usual = [problem.value(t), median(known)];
      s.noiseVar = law{t}(usual(1 + isnan (usual(1))));
    end
    surrogates(t) = s;
  end
end

function form = ofTarget (form, t)
  if ~isempty (form)
    form = form(t);
  end
end

% Of which model each response is, and what findBadRuns needs beside: a curve
% counts as one response, and what is within the tolerance is not wrong.
function kind = kindOfTarget (problem)
  kind.model = problem.bench;
  kind.weight = ones (1, numel (problem.bench));
  for number = unique (problem.curve(problem.curve > 0))
    points = problem.curve == number;
    kind.weight(points) = 1 / sum (points);
  end
  kind.judges = problem.calibrate;
  kind.least = problem.tol .* abs (problem.scale);
  kind.least(isnan (kind.least)) = 0;      % not measured yet
end

%!function data = planned (X, Z)
%!  data = addRows (newData (columns (X), columns (Z)), X, Z, ...
%!                  ones (rows (X), 1), 'plan');
%!endfunction
%!shared X
%! rand ('twister', 1);
%! randn ('twister', 1);
%! X = rand (90, 2);

%!test
%! data = planned (X(1:10, :), [sum(X(1:10, :), 2), X(1:10, 1)]);
%! s = fitSurrogates (data, smallProblem ([1, 2], 0.01, 2));
%! assert (size (s), [1, 2]);
%! assert (s(2).name, 'target_2');
%! assert (predictSurrogate (s, [0.5, 0.4]), [0.9, 0.5], 0.02);
%! s = fitSurrogates (data, smallProblem ([1, 2], 0.01, 2), s);
%! assert (predictSurrogate (s, [0.5, 0.4]), [0.9, 0.5], 0.02);

%!test
%! % a form that is known: its trend and noise count, not what three runs show
%! problem = smallProblem (2, 0.01);
%! problem.form = struct ('trend', 'affine', 'covariance', 'gauss', 'param', ...
%!                        [log(1e-8); 0], 'limits', [0; 1], 'shift', 1, ...
%!                        'scale', 2, 'noise', @(z) 0.01 + 0 * z);
%! u = [0; 0.5; 1];
%! s = fitSurrogates (planned (u, 1 + u), problem);
%! [m, v] = predictSurrogate (s, 0.5);
%! assert ([m, v], [1.5, 0.01 / 3], 1e-6);
%! assert ([s.noiseVar, s.df], [0.01, 1e6], 1e-12);

%!test
%! % rows of another model keep their place in what is left out
%! data = planned (X(1:14, 1), 1 + X(1:14, 1) + 0.01 * sin (40 * X(1:14, 1)));
%! data.Z([2, 9]) = [7, 5];
%! data.E = double ((1:14)' == 2);
%! s = fitSurrogates (data, smallProblem (1, 0.01));
%! assert ({find(s.suspect)', any(s.leftOut)}, {9, false});
%! data = addRows (data, X(9, 1), 1 + X(9, 1), 2, 'repeat');
%! s = fitSurrogates (data, smallProblem (1, 0.01));
%! assert ({find(s.leftOut)', s.aside, any(s.suspect)}, {9, 5, false});
%! assert (find (fitSurrogates (data, smallProblem (1, 0.01), s).leftOut)', 9);

%!test
%! % scatter in proportion to the response (12 sets of 4 runs)
%! P = kron (X(1:12, 1), ones (4, 1));
%! Z = (1 + 9 * P) .* (1 + 0.05 * randn (48, 1));
%! s = fitSurrogates (planned (P, Z), smallProblem (2, 0.01));
%! assert (sqrt (s.noiseVar), 0.1, 0.04);
%! assert (numel (s.model.lognoisevariance), 48);

%!test
%! % more runs than memory holds: a part is fitted, at all levels
%! data = planned (X(:, 1), 1 + X(:, 1));
%! problem = smallProblem (2, 0.01);
%! s = fitSurrogates (data, problem, [], 30);
%! assert ({numel(s.z), size(s.leftOut)}, {30, [90, 1]});
%! assert (predictSurrogate (s, 0.4), 1.4, 1e-3);
%! problem.coarse = struct ('levels', [2; 1], 'column', 1);
%! data.E = repmat ([2; 1; 1], 30, 1);
%! data.Z += 0.1 * (data.E - 1);
%! s = fitSurrogates (data, problem, [], 40);
%! assert (numel (s.z), 40);
%! assert (predictSurrogate (s, 0.4), 1.4, 1e-3);

% SPDX-License-Identifier: GPL-3.0-only
