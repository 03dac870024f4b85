% FOREIGNNOISE  Draws noise that is correlated and, if so wished, heavy-tailed.
%
% CALL: NOISE = foreignNoise (SD, CORRELATION, BENCH, DF)
%
%   SD           n x T, standard deviations
%   CORRELATION  T x T, of the results of one run
%   BENCH        1 x T, numbers of benches
%   DF           whole number above 2, degrees of freedom of Student's t, or Inf
%   NOISE        n x T, from the current random state, of standard deviation SD
%
% Heavy tails strike a run of a bench as a whole (multivariate t).
%
% See also: foreignLab

function noise = foreignNoise (sd, correlation, bench, df)
  [n, T] = size (sd);
  noise = randn (n, T) * chol (correlation);
  if isfinite (df)
    for b = unique (bench)
      at = bench == b;
      spread = sqrt ((df - 2) ./ sum (randn (n, df).^2, 2));
      noise(:, at) = noise(:, at) .* spread;
    end
  end
  noise = sd .* noise;
end

%!test
%! % 2e5 draws: variance of t with 5 degrees of freedom within 3 % (5 standard
%! % errors), correlation kept, tails beyond 4 a hundred times those of a normal
%! randn ('twister', 1);
%! C = [1, 0.5, 0; 0.5, 1, 0; 0, 0, 1];
%! x = foreignNoise (ones (2e5, 1) * [1, 2, 3], C, [1, 1, 2], 5);
%! assert (std (x), [1, 2, 3], [0.03, 0.06, 0.09]);
%! assert (corr (x(:, 1), x(:, 2)), 0.5, 0.03);
%! assert (mean (abs (x(:, 1)) > 4) > 30 * erfc (4 / sqrt (2)));
%!test
%! randn ('twister', 1);
%! x = foreignNoise (ones (1e5, 2), eye (2), [1, 1], Inf);
%! assert (mean (abs (x(:)) > 3), erfc (3 / sqrt (2)), 6e-4);
%!test % same state, same noise
%! randn ('twister', 3);
%! a = foreignNoise (ones (4, 2), eye (2), [1, 2], 4);
%! randn ('twister', 3);
%! assert (foreignNoise (ones (4, 2), eye (2), [1, 2], 4), a);
