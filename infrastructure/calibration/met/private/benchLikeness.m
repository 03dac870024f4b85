% BENCHLIKENESS  How alike what the targets of a bench are off by is.
%
% CALL: LIKENESS = benchLikeness (SURROGATES, PROBLEM, JOINT, ALONE, V)
%
%   JOINT, ALONE  of jointErrors;  V  1 x T, usual variance of the surrogates
%   LIKENESS  1 x B struct, for each bench: alone (1 x a, numbers of
%             these), curves (1 x c, numbers in JOINT), correlation (a + c square, in
%             this order; a curve takes part by its level), variance (1 x a,
%             errorVariance), freedom and wider (1 x a, see benchDensity)
%
% Readings of one packing scatter together, and so do runs: the correlation of the
% leave-one-out residuals, shrunk towards their mean one by as much as so few runs
% leave open (Schaefer and Strimmer 2005). It is that of the packing and of the
% surrogate; what an instrument adds is each reading's own, and its size is known.
%
% See also: benchDensity, parameterPosterior

function likeness = benchLikeness (surrogates, problem, joint, alone, v)
  likeness = struct ('alone', {}, 'curves', {}, 'correlation', {}, 'variance', {}, ...
                     'freedom', {}, 'wider', {});
  first = arrayfun (@(c) c.points(1), joint);
  for bench = unique (problem.bench([alone, first]))
    here = alone(problem.bench(alone) == bench);
    curves = find (problem.bench(first) == bench);
    variance = arrayfun (@(t) errorVariance (surrogates(t).noiseVar, problem, t), here);
    variance = reshape (variance, 1, []);        % also of a bench of curves alone
    own = problem.statedSd(here).^2 .* ~problem.scatter(here);
    % what packing and surrogate have of the variance of each
    share = [max(1 - own ./ (variance + v(here)), 0), ...
             arrayfun(@(c) c.share, joint(curves))(:)'];
    E = residualsOf (surrogates, here, joint(curves));
    R = full (eye (numel (share)));
    if rows (E) > 3
      R = shrunk (E);
    end
    root = sqrt (share);
    df = min ([surrogates(here).df, Inf]);
    freedom = max (df - numel (here) + 1, min (df, 3));
    likeness(end + 1) = ...
      struct ('alone', here, 'curves', curves(:)', 'correlation', ...
              full (eye (numel (share))) + (root' * root) .* (R - eye (numel (share))), ...
              'variance', variance, 'freedom', freedom, 'wider', ...
              1 + share(1:numel (here)) * (df / freedom - 1));
  end
end

% A column a single target and a curve.
function E = residualsOf (surrogates, alone, curves)
  points = arrayfun (@(c) c.points, curves, 'UniformOutput', false);
  all_ = looRows (surrogates([alone, points{:}]));
  E = all_(:, 1:numel (alone));
  at = numel (alone);
  for c = curves
    E(:, end + 1) = all_(:, at + (1:numel (c.points))) * c.weight;
    at = at + numel (c.points);
  end
  E = E(all (isfinite (E), 2), :);
end

function R = shrunk (E)
  [n, m] = size (E);
  scale = sqrt (sum (E.^2, 1));
  R = (E' * E) ./ max (scale' * scale, realmin);
  isOff = ~eye (m);
  % below this the mean one is none of m results
  usual = max (mean (R(isOff)), -0.9 / max (m - 1, 1));
  open = sum ((1 - R(isOff).^2).^2) / (n - 1);
  share = min (open / max (sumsq (R(isOff) - usual), realmin), 1);
  R(isOff) = (1 - share) * R(isOff) + share * usual;
  R(~isOff) = 1 + 1e-6;
end

%!function one = likenessOf (E, changes)
%!  T = columns (E);
%!  s = struct ('looStd', mat2cell (E, rows (E), ones (1, T)), 'noiseVar', 4, 'df', 18);
%!  problem = struct ('bench', ones (1, T), 'trials', ones (1, T), ...
%!                    'statedSd', zeros (1, T), 'scatter', false (1, T), ...
%!                    'tol', 0.1 * ones (1, T), 'scale', ones (1, T));
%!  one = benchLikeness (s, mergeFields (problem, changes), [], 1:T, zeros (1, T));
%!endfunction
%!test
%! % what moves together is seen; what does not, hardly (seeded)
%! randn ('twister', 2);
%! own = randn (20, 4);
%! E = sqrt (0.9) * randn (20, 1) + sqrt (0.1) * own;
%! one = likenessOf (E, struct ());
%! assert (one.correlation(1, 2:4), 0.9 * ones (1, 3), 0.1);
%! assert ({one.freedom, one.wider}, {15, 1.2 * ones(1, 4)}, 1e-12);
%! R = likenessOf (own, struct ()).correlation;
%! assert (max (abs (R(1, 2:4))) < 0.2);
%! % an instrument as unsure as the packing leaves half of it, and its size is known
%! half = likenessOf (E, struct ('statedSd', 2 * ones (1, 4)));
%! assert (half.correlation(1, 2:4), one.correlation(1, 2:4) / 2, 1e-6);
%! assert (half.wider, 1.1 * ones (1, 4), 1e-12);
%! % of other benches, of few runs, and of one target there is none
%! apart = likenessOf (E, struct ('bench', 1:4));
%! assert ([apart.correlation], ones (1, 4), 1e-5);
%! assert (likenessOf (E(1:3, :), struct ()).correlation, full (eye (4)));

% SPDX-License-Identifier: GPL-3.0-only
