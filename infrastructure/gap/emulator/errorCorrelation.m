% ERRORCORRELATION  How alike the errors of a run's results are.
%
% CALL: [C, ALONG] = errorCorrelation (R, GAPPROBLEM)
%
%   R           n x T, standardised residuals of runs
%   GAPPROBLEM  struct bench, series, coordinate (1 x T, see newGapProblem)
%   C           T x T, correlation within a bench, 0 between benches
%   ALONG       T x T, that of neighbours on a curve of eight points or more:
%               exp (-distance / length), 1 on the diagonal, else 0
%
% The sample's correlations are shrunk towards ALONG by n / (n + 2 T): 40 runs
% do not tell those of 60 points. Shrunk towards none, the error of a smooth
% surrogate along a curve, which has few degrees of freedom, would be taken for
% 60 errors that average out. The length makes ALONG nearest to the sample
% (least squares).

function [C, along] = errorCorrelation (R, gapProblem)
  [n, T] = size (R);
  scale = sqrt (sum (R.^2, 1));
  S = (R' * R) ./ max (scale' * scale, realmin);
  along = eye (T);
  for s = setdiff (gapProblem.series, 0)
    own = find (gapProblem.series == s);
    apart = abs (gapProblem.coordinate(own)' - gapProblem.coordinate(own));
    if numel (own) >= 8 && n > 0
      along(own, own) = exp (-apart / fittedLength (S(own, own), apart));
    end
  end
  share = n / (n + 2 * T);
  C = share * S + (1 - share) * along;
  C(gapProblem.bench' ~= gapProblem.bench) = 0;
  C(1:T + 1:end) = 1;
end

function len = fittedLength (S, apart)
  misfit = @(logL) sum (sum ((S - exp (-apart / exp (logL))).^2));
  least = min (apart(apart > 0));
  len = exp (fminbnd (misfit, log (least / 3), log (max (apart(:)))));
end

%!shared gapProblem
%! gapProblem = struct ('bench', [1, 1, 2], 'series', zeros (1, 3), ...
%!                      'coordinate', zeros (1, 3));
%!test
%! % no curve: shrunk towards independence, nothing between benches
%! R = [1, 1, 0; -1, -1, 0; 1, 1, 1; -1, -1, -1];
%! [C, along] = errorCorrelation (R, gapProblem);
%! assert (along, eye (3));
%! assert (C, [1, 0.4, 0; 0.4, 1, 0; 0, 0, 1], 1e-12);
%!test
%! % a curve of 20 points with errors of length 5: found from 12 runs (seeded;
%! % half to twice the length in 99 of 100 other seeds)
%! randn ('twister', 4);
%! at = 1:20;
%! curve = struct ('bench', ones (1, 20), 'series', ones (1, 20), ...
%!                 'coordinate', at);
%! R = randn (12, 20) * chol (exp (-abs (at' - at) / 5));
%! [C, along] = errorCorrelation (R, curve);
%! len = -1 / log (along(1, 2));
%! assert (len > 2.5 && len < 10);
%! assert (C(3, 4) > 0.6);
