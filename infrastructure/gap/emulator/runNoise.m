% RUNNOISE  Scatter of one run, from repeats and, where these are few, nuggets.
%
% CALL: EM = runNoise (EM, GAPPROBLEM, DATA)
%
%   EM          struct of fitEmulator: surrogates and range are read; gets
%               noiseVar, noiseFreedom, correlation, alongCurve
%   GAPPROBLEM  struct of newGapProblem;  DATA  struct X, E, Z

function em = runNoise (em, gapProblem, data)
  [measured, df, residual] = ofRepeats ([data.X, data.E], data.Z);
  nugget = max ([em.surrogates.noiseVar], (1e-8 * em.range).^2);
  weight = df ./ (df + 5);
  measured(df == 0) = 0;
  em.noiseVar = weight .* measured + (1 - weight) .* nugget;
  em.noiseFreedom = df + [em.surrogates.df];
  known = isfinite (gapProblem.noiseSd);
  em.noiseVar(known) = gapProblem.noiseSd(known).^2;
  em.noiseFreedom(known) = Inf;
  residual = residual(all (isfinite (residual), 2), :);
  R = [looRows(em.surrogates); residual ./ sqrt(em.noiseVar)];
  R = R(all (isfinite (R), 2), :);
  [em.correlation, em.alongCurve] = errorCorrelation (R, gapProblem);
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

% Leave-one-out residuals, where all targets have the same runs.
function R = looRows (surrogates)
  lengths = arrayfun (@(s) numel (s.looStd), surrogates);
  R = zeros (0, numel (surrogates));
  if all (lengths == lengths(1))
    R = [surrogates.looStd];
  end
end

%!test
%! % 1 and 2: repeats of freedom 2 and 1 beside nuggets of 10; 3: known
%! s = struct ('noiseVar', 10, 'df', 3, 'looStd', zeros (0, 1));
%! em = struct ('surrogates', [s, s, s], 'range', [1, 1, 1]);
%! gapProblem = struct ('noiseSd', [NaN, NaN, 3], 'bench', [1, 1, 1], ...
%!                      'series', zeros (1, 3), 'coordinate', zeros (1, 3));
%! data = struct ('X', [1; 1; 2; 3; 3], 'E', zeros (5, 0), 'Z', ...
%!                [1, 5, 0; 3, NaN, 0; 9, 9, 0; 4, 1, 0; 4, 3, 0]);
%! em = runNoise (em, gapProblem, data);
%! assert (em.noiseVar, [2 / 7 + 50 / 7, 2 / 6 + 50 / 6, 9], 1e-12);
%! assert (em.noiseFreedom, [5, 4, Inf]);
