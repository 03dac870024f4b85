% RUNNOISE  Scatter of one run, from repeats and, where these are few, nuggets.
%
% CALL: EMULATOR = runNoise (EMULATOR, PROBLEM, DATA)
%
%   EMULATOR    struct of fitEmulator: surrogates and range are read; gets
%               noiseVar, noiseFreedom, and (T x T) correlation, of the errors
%               of a run's results within a bench, and misfitLikeness, that of
%               neighbours on a curve of eight points or more: exp (-distance /
%               length), 1 on the diagonal, else 0; the length makes it nearest
%               to the sample (least squares). A response without scatter has
%               that of a thousandth of its range: no polynomial follows it
%               better
%   PROBLEM     struct of newProblem;  DATA  struct X, E, Z, level

function emulator = runNoise (emulator, problem, data)
  [measured, df, residual] = ofRepeats ([data.X, data.E, data.level], ...
                                        data.Z);
  nugget = [emulator.surrogates.noiseVar];
  % a nugget is worth five degrees of freedom of repeats: it holds what the Kriging
  % misses, too
  weight = df ./ (df + 5);
  measured(df == 0) = 0;
  emulator.noiseVar = max (weight .* measured + (1 - weight) .* nugget, ...
                           (1e-3 * emulator.range).^2);
  emulator.noiseFreedom = df + [emulator.surrogates.df];
  % what is stated needs no estimate
  known = isfinite (problem.noiseSd);
  emulator.noiseVar(known) = problem.noiseSd(known).^2;
  emulator.noiseFreedom(known) = Inf;
  residual = residual(all (isfinite (residual), 2), :);
  R = [looRows(emulator.surrogates); residual ./ sqrt(emulator.noiseVar)];
  R = R(all (isfinite (R), 2), :);
  [emulator.correlation, emulator.misfitLikeness] = errorCorrelation (R, problem);
end

% Pooled variance (NaN where none) and degrees of freedom, 1 x T; deviation of
% each run from the mean of its group (NaN: alone).
function [variance, df, residual] = ofRepeats (inputs, Z)
  [~, ~, group] = unique (inputs, 'rows');
  residual = NaN (size (Z));
  df = zeros (1, columns (Z));
  total = df;
  for g = find (accumarray (group(:), 1)' > 1)
    in = find (group(:)' == g);
    for t = 1:columns (Z)
      ok = in(isfinite (Z(in, t)));
      if numel (ok) > 1
        residual(ok, t) = Z(ok, t) - mean (Z(ok, t));
        total(t) = total(t) + sum (residual(ok, t).^2);
        df(t) = df(t) + numel (ok) - 1;
      end
    end
  end
  variance = total ./ df;
end

% Correlation of the errors of a run's results, from standardised residuals R (n
% x T): that of the sample, shrunk towards ALONG by n / (n + 2 T), for 40 runs
% do not tell those of 60 points. Shrunk towards none, the error of a smooth
% surrogate along a curve would be taken for 60 errors that average out.
function [C, along] = errorCorrelation (R, problem)
  [n, T] = size (R);
  scale = sqrt (sum (R.^2, 1));
  S = (R' * R) ./ max (scale' * scale, realmin);
  along = eye (T);
  for s = setdiff (problem.series, 0)
    points = find (problem.series == s);
    apart = abs (problem.coordinate(points)' - problem.coordinate(points));
    if numel (points) >= 8 && n > 0
      along(points, points) = exp (-apart / fittedLength (S(points, points), apart));
    end
  end
  share = n / (n + 2 * T);
  C = share * S + (1 - share) * along;
  C(problem.bench' ~= problem.bench) = 0;
  C(1:T + 1:end) = 1;
end

function len = fittedLength (S, apart)
  misfit = @(logL) sum (sum ((S - exp (-apart / exp (logL))).^2));
  least = min (apart(apart > 0));
  % between a third of the least distance (independent) and the whole series (one
  % error)
  len = exp (fminbnd (misfit, log (least / 3), log (max (apart(:)))));
end

%!test
%! % 1 and 2: repeats of freedom 2 and 1 beside nuggets of 10; 3: known
%! s = struct ('noiseVar', 10, 'df', 3, 'looStd', zeros (0, 1));
%! emulator = struct ('surrogates', [s, s, s], 'range', [1, 1, 1]);
%! problem = struct ('noiseSd', [NaN, NaN, 3], 'bench', [1, 1, 1], ...
%!                   'series', zeros (1, 3), 'coordinate', zeros (1, 3));
%! data = struct ('X', [1; 1; 2; 3; 3], 'E', zeros (5, 0), 'Z', ...
%!                [1, 5, 0; 3, NaN, 0; 9, 9, 0; 4, 1, 0; 4, 3, 0], 'level', ...
%!                zeros (5, 3));
%! emulator = runNoise (emulator, problem, data);
%! assert (emulator.noiseVar, [2 / 7 + 50 / 7, 2 / 6 + 50 / 6, 9], 1e-12);
%! assert (emulator.noiseFreedom, [5, 4, Inf]);
%! % nothing scatters, in repeats or between them
%! [emulator.surrogates.noiseVar] = deal (0);
%! emulator.range = [5, 5, 5];
%! data.Z(:) = 1;
%! assert (runNoise (emulator, problem, data).noiseVar, [25e-6, 25e-6, 9], 1e-12);
%!function emulator = withResiduals (R, curve)
%!  T = columns (R);
%!  curve.noiseSd = NaN (1, T);
%!  s = struct ('noiseVar', 1, 'df', 3, 'looStd', num2cell (R, 1));
%!  emulator = struct ('surrogates', s, 'range', ones (1, T));
%!  data = struct ('X', 1, 'E', zeros (1, 0), 'Z', ones (1, T), ...
%!                 'level', zeros (1, T));
%!  emulator = runNoise (emulator, curve, data);
%!endfunction
%!test
%! % no curve: shrunk towards independence, nothing between benches
%! R = [1, 1, 0; -1, -1, 0; 1, 1, 1; -1, -1, -1];
%! curve = struct ('bench', [1, 1, 2], 'series', zeros (1, 3), ...
%!                 'coordinate', zeros (1, 3));
%! emulator = withResiduals (R, curve);
%! assert (emulator.misfitLikeness, eye (3));
%! assert (emulator.correlation, [1, 0.4, 0; 0.4, 1, 0; 0, 0, 1], 1e-12);
%!test
%! % a curve of 20 points with errors of length 5: found from 12 runs (seeded;
%! % half to twice the length in 99 of 100 other seeds)
%! randn ('twister', 4);
%! at = 1:20;
%! curve = struct ('bench', ones (1, 20), 'series', ones (1, 20), ...
%!                 'coordinate', at);
%! R = randn (12, 20) * chol (exp (-abs (at' - at) / 5));
%! emulator = withResiduals (R, curve);
%! len = -1 / log (emulator.misfitLikeness(1, 2));
%! assert (len > 2.5 && len < 10);
%! assert (emulator.correlation(3, 4) > 0.6);

% SPDX-License-Identifier: GPL-3.0-only
