% BENDINPUTS  Inputs along which the slope of a response changes much.
%
% CALL: BENDS = bendInputs (SURROGATE)
%
% SURROGATE  struct of fitSurrogate, its inputs straight
% BENDS      2 x k, worth trying, in this order: number of the input, and by
%            how much to bend it (the fourth row of limits, see toUnit)
%
% A Kriging model takes a response for equally rough all over the box. Where it
% grows like exp (5 u) it is not: one range is too long at one end and too short
% at the other. The slope in fifths of the box tells (root mean square over the
% other inputs): where it changes by more than a factor of 30 from end to end (15
% between fifths, which take a mean), and is no trifle at its largest, the steep
% end is stretched by a factor of 20, and of 400. Two inputs at most, as each try
% is one more fit.

function bends = bendInputs (surrogate)
  d = columns (surrogate.limits);
  [ratio, side] = deal (zeros (1, d));
  for j = 1:d
    slope = slopesAlong (surrogate, j);
    isTrifle = max (slope) < 0.5;      % in standard deviations over the box
    ratio(j) = max (slope) / max (min (slope), realmin) * ~isTrifle;
    side(j) = sign (slope(end) - slope(1));
  end
  [~, order] = sort (ratio, 'descend');
  chosen = order(1:min (2, d));
  chosen = chosen(ratio(chosen) > 15 & side(chosen) ~= 0);
  bends = [kron(chosen, [1, 1]); kron(side(chosen), [3, 6])];
end

function slope = slopesAlong (surrogate, j)
  [n, nPart] = deal (40, 5);
  box = [0; 1] .* ones (2, columns (surrogate.limits));
  U = double (stk_sampling_halton_rr2 (n, columns (box), box));
  U = repmat (U, nPart + 1, 1);
  U(:, j) = kron ((0:nPart)' / nPart, ones (n, 1));
  m = reshape (predictSurrogate (surrogate, fromUnit (U, surrogate.limits)), ...
               n, nPart + 1);
  slope = sqrt (mean (diff (m, 1, 2).^2, 1)) * nPart / surrogate.scale;
end

%!function [X, limits] = plan ()
%!  limits = [0, 1e3; 2, 1e5; 0, 1];
%!  restore = seedRandom (4);
%!  X = fromUnit (double (stk_sampling_maximinlhs (14, 2, [0, 0; 1, 1], ...
%!                                                 200)), limits);
%!endfunction
%!test <*47>
%! pkg load stk
%! [X, limits] = plan ();
%! f = @(X) exp (2.5 * X(:, 1)) .* (1 + 0.2 * log10 (X(:, 2)));
%! fixed = struct ('trend', 'quadratic', 'covariance', 'gauss');
%! straight = fitSurrogate (X, f (X), limits, fixed);
%! assert (bendInputs (straight), [1, 1; 3, 6]);
%! % taken for a gain, and twice as near then
%! s = fitSurrogate (X, f (X), limits);
%! assert (s.limits, [limits; 3, 0] .* [1; 1; 1; s.limits(4, 1) / 3]);
%! assert (s.score > straight.score + 1.5);
%! P = sampleBox (200, limits);
%! miss = @(s) sqrt (mean ((predictSurrogate (s, P) - f (P)).^2));
%! assert (miss (s) < 0.5 * miss (straight));
%! % kept by a fit that starts from it
%! again = fitSurrogate (X, f (X), limits, struct ('start', s));
%! assert (again.limits, s.limits);
%! assert (predictSurrogate (again, P), predictSurrogate (s, P), 0.05);
%!test
%! % falling towards the other end; nothing to gain where it is straight
%! pkg load stk
%! [X, limits] = plan ();
%! s = fitSurrogate (X, exp (-3 * X(:, 1)), limits);
%! assert (s.limits(4, 1) < 0 && s.limits(4, 2) == 0);
%! P = sampleBox (100, limits);
%! file = tempname ();
%! saveSurrogates (s, file);
%! addpath (file);
%! assert (KM_fun_1 (P), predictSurrogate (s, P), 1e-9);
%! kept = loadSurrogate (fullfile (file, 'KM_fun_1.txt'));
%! assert (predictSurrogate (kept, P), predictSurrogate (s, P), 1e-9);
%! rmpath (file);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (file, 's');
%! s = fitSurrogate (X, X(:, 1) + log (X(:, 2)), limits);
%! assert (isempty (bendInputs (s)));
%! assert (s.limits, limits);

% SPDX-License-Identifier: GPL-3.0-only
