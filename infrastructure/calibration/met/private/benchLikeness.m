% BENCHLIKENESS  How alike what the targets of a bench are off by is.
%
% CALL: LIKENESS = benchLikeness (SURROGATES, PROBLEM, JOINT, ALONE, V)
%
%   JOINT, ALONE  of jointErrors;  V  1 x T, usual variance of the surrogates
%   LIKENESS  1 x B struct, a bench of several such targets each: alone (numbers of
%             single ones), curves (numbers in JOINT) and correlation, of the normal
%             scores of these, in this order; a curve takes part by its level
%
% Readings of one packing scatter together, and so do runs: the correlation of the
% leave-one-out residuals, shrunk towards none by as much as so few runs leave open
% (Schaefer and Strimmer 2005). It is that of the packing and of the surrogate; what
% an instrument adds is each reading's own.
%
% See also: withLikeness, parameterPosterior

function likeness = benchLikeness (surrogates, problem, joint, alone, v)
  likeness = struct ('alone', {}, 'curves', {}, 'correlation', {});
  first = arrayfun (@(c) c.points(1), joint);
  for bench = unique (problem.bench([alone, first]))
    one = struct ('alone', alone(problem.bench(alone) == bench), ...
                  'curves', find (problem.bench(first) == bench), 'correlation', []);
    [E, share] = residualsOf (surrogates, problem, joint(one.curves), one.alone, v);
    if columns (E) > 1 && rows (E) > 3
      root = sqrt (share);
      one.correlation = full (eye (numel (share))) + ...
                        (root' * root) .* (shrunk (E) - eye (numel (share)));
      likeness(end + 1) = one;
    end
  end
end

% A column a single target and a curve; SHARE of its variance that packing and
% surrogate have.
function [E, share] = residualsOf (surrogates, problem, curves, alone, v)
  share = zeros (1, 0);
  for t = alone
    noise = surrogates(t).noiseVar;
    own = problem.statedSd(t)^2 * ~problem.scatter(t);
    total = errorVariance (noise, problem, t) + v(t);
    share(end + 1) = max (1 - own / total, 0);
  end
  points = arrayfun (@(c) c.points, curves, 'UniformOutput', false);
  E = looRows (surrogates([alone, points{:}]));
  level = zeros (rows (E), 0);
  at = numel (alone);
  for c = curves
    own = at + (1:numel (c.points));
    level(:, end + 1) = E(:, own) * c.weight;
    share(end + 1) = c.share;
    at = own(end);
  end
  E = [E(:, 1:numel (alone)), level];
  E = E(all (isfinite (E), 2), :);
end

function R = shrunk (E)
  n = rows (E);
  scale = sqrt (sum (E.^2, 1));
  R = (E' * E) ./ max (scale' * scale, realmin);
  R(1:columns (R) + 1:end) = 0;
  open = sum (sum ((1 - R.^2).^2 .* (1 - eye (columns (R))))) / (n - 1);
  share = min (open / max (sum (sum (R.^2)), realmin), 1);
  R = (1 - share) * R;
  R(1:columns (R) + 1:end) = 1;
end

%!function R = correlationOf (E, changes)
%!  T = columns (E);
%!  s = struct ('looStd', mat2cell (E, rows (E), ones (1, T)), 'noiseVar', 4);
%!  problem = struct ('bench', ones (1, T), 'trials', ones (1, T), ...
%!                    'statedSd', zeros (1, T), 'scatter', false (1, T), ...
%!                    'tol', 0.1 * ones (1, T), 'scale', ones (1, T));
%!  likeness = benchLikeness (s, mergeFields (problem, changes), [], 1:T, zeros (1, T));
%!  R = [likeness.correlation];
%!endfunction
%!test
%! % what moves together is seen; what does not, hardly (seeded)
%! randn ('twister', 2);
%! own = randn (20, 4);
%! E = sqrt (0.9) * randn (20, 1) + sqrt (0.1) * own;
%! R = correlationOf (E, struct ());
%! assert (R(1, 2:4), 0.9 * ones (1, 3), 0.1);
%! R = correlationOf (own, struct ());
%! assert (max (abs (R(1, 2:4))) < 0.2);
%! % an instrument as unsure as the packing leaves half of it
%! R = correlationOf (E, struct ('statedSd', 2 * ones (1, 4)));
%! assert (R(1, 2:4), 0.45 * ones (1, 3), 0.05);
%! % other benches, one target, and too few runs have none
%! assert (isempty (correlationOf (E, struct ('bench', 1:4))));
%! assert (isempty (correlationOf (E(:, 1), struct ())));
%! assert (isempty (correlationOf (E(1:3, :), struct ())));
