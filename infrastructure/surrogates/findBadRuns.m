% FINDBADRUNS  Finds runs that are off by far more than runs scatter.
%
% CALL: BAD = findBadRuns (X, Z, MODEL, SURROGATES, OLD)
%
%   X           n x d, parameter sets
%   Z           n x T, responses (NaN: none)
%   MODEL       1 x T, number of the model that each response belongs to
%   SURROGATES  1 x T struct of fitSurrogate, fitted to all rows but OLD
%   OLD         n x T logical, runs found bad before
%   BAD         n x T logical: all responses of a run share one judgement
%
% A wrong start state, a lost wall: such a run is neither failed nor scatter. It
% is left out where the responses of its model are likelier so: with the
% restricted likelihoods l of all runs and of all but run i, each at its own
% parameters, run i is bad where the sum over the responses of
%
%   l(all but i) - log (6 s) - l(all)    exceeds    log (0.9 / 0.1)
%
% that is against a run that may lie anywhere within 6 standard deviations s of
% the others (Box and Tiao 1968: a small share of runs of another, wide
% distribution). Added and taken back one by one, two at once where one hides
% the other. At most a quarter of the runs; at least d + 3 stay.
%
% See also: fitSurrogates, penalisedLikelihood, confirmSet

function bad = findBadRuns (X, Z, model, surrogates, old)
  bad = old;
  for m = unique (model)
    own = model == m;
    rowsOf = all (isfinite (Z(:, own)), 2);
    task = struct ('X', X(rowsOf, :), 'Z', Z(rowsOf, own), ...
                   'surrogates', {surrogates(own)});
    out = judge (task, any (old(rowsOf, own), 2));
    bad(:, own) = false;
    bad(rowsOf, own) = repmat (out, 1, sum (own));
  end
end

function out = judge (task, out)
  % a run that was bad before may fit now that more is known
  out = takeBack (task, out);
  d = columns (task.X);
  most = min (floor (rows (task.X) / 4), rows (task.X) - d - 3);
  odds = log (0.9 / 0.1);
  while sum (out) < most
    [order, worst] = suspects (task, out);
    if worst < 2
      return
    end
    best = odds;
    with = [];
    now = evidence (task, out);
    for pick = {order(1), order(2), order(1:2)}
      if sum (out) + numel (pick{1}) > most
        continue
      end
      tried = out;
      tried(pick{1}) = true;
      gain = evidence (task, tried) - now - (numel (pick{1}) - 1) * odds;
      if gain > best
        best = gain;
        with = tried;
      end
    end
    if isempty (with)
      return
    end
    out = with;
  end
end

function out = takeBack (task, out)
  odds = log (0.9 / 0.1);
  for i = find (out)'
    tried = out;
    tried(i) = false;
    if evidence (task, out) - evidence (task, tried) < odds
      out = tried;
    end
  end
end

% Runs by how far they lie from what the others predict, in its deviations.
function [order, worst] = suspects (task, out)
  far = zeros (rows (task.X), 1);
  for t = 1:columns (task.Z)
    s = fitted (task, t, out);
    z = zeros (rows (far), 1);
    z(~out) = abs (s.looStd);
    far = max (far, z);
  end
  [far, order] = sort (far, 'descend');
  worst = far(1);
end

% Log density of all runs: the good ones by the surrogates, the bad ones wide.
function total = evidence (task, out)
  total = 0;
  for t = 1:columns (task.Z)
    s = fitted (task, t, out);
    fit = prepareFit (s.solver.unit, s.solver.y, s.trend, s.covariance, []);
    theta = [s.model.param(:); s.model.lognoisevariance(1)];
    total = total - penalisedLikelihood (theta, fit) - ...
            columns (fit.W) * log (s.scale) - ...
            sum (out) * log (6 * std (task.Z(~out, t)));
  end
end

function s = fitted (task, t, out)
  old = task.surrogates(t);
  options = struct ('trend', old.trend, 'covariance', old.covariance);
  s = fitSurrogate (task.X(~out, :), task.Z(~out, t), old.limits, options);
end

%!shared X, Z, limits, fit
%! pkg load stk
%! rand ('twister', 3);
%! randn ('twister', 3);
%! limits = [0, 0, 0; 1, 1, 1];
%! X = rand (16, 3);
%! Z = [3 + 2 * X(:, 1) - X(:, 3), 1 + X(:, 1) + X(:, 2)] .* ...
%!     (1 + 0.01 * randn (16, 2));
%! fit = @(Z) [fitSurrogate(X, Z(:, 1), limits), ...
%!             fitSurrogate(X, Z(:, 2), limits)];

%!test
%! % nothing is wrong
%! bad = findBadRuns (X, Z, [1, 1], fit (Z), false (16, 2));
%! assert (~ any (bad(:)));

%!test
%! % two wrong runs; what is found stays found, a run that is good comes back
%! W = Z;
%! W([4, 9], :) = W([4, 9], :) .* [1.3, 0.7; 0.75, 1.25];
%! bad = findBadRuns (X, W, [1, 1], fit (W), false (16, 2));
%! assert (find (bad(:, 1))', [4, 9]);
%! assert (bad(:, 1), bad(:, 2));
%! wrong = false (16, 2);
%! wrong(2, :) = true;
%! again = findBadRuns (X, W, [1, 1], fit (W), bad | wrong);
%! assert (again, bad);

%!test
%! % each model of its own; a failed run is none of its business
%! W = Z;
%! W(5, 1) = 2 * W(5, 1);
%! W(7, 2) = NaN;
%! bad = findBadRuns (X, W, [1, 2], fit (W), false (16, 2));
%! assert (find (bad)', 5);
