% ADDCORRELATION  Adds to a gapProblem that errors are alike along a series.
%
% CALL: [GIVEN, NOTES] = addCorrelation (GIVEN, TARGETS)
%
%   GIVEN    struct of gapProblemOf with value, sd, held, series, coordinate,
%            bench and benchNames; gets estimateSeries (1 x T logical: the
%            length is to be estimated) and, where lengths are known,
%            covariance (T x T)
%   TARGETS  1 x T struct of a case; its field correlation is the length, 0:
%            independent, NaN: to be estimated
%   NOTES    cellstr, benches of which a length was given in vain
%
% A length means nothing where the target has no neighbour on its series.
%
% See also: gapProblemOf, measurementCovariance, estimateCorrelation

function [given, notes] = addCorrelation (given, targets)
  notes = {};
  lengths = [targets.correlation];
  isAsked = lengths ~= 0;
  % a length is learned from what is measured and fitted
  counts = isAsked & ~(isnan (lengths) & (isnan (given.value) | given.held));
  together = given.series' == given.series & given.series > 0 & ...
             counts' & isAsked;
  hasNeighbour = sum (together) > 1;
  given.estimateSeries = hasNeighbour & isnan (lengths);
  lengths(~hasNeighbour | isnan (lengths)) = 0;
  if any (lengths > 0)
    given.covariance = measurementCovariance (given.sd, given.series, ...
                                              given.coordinate, lengths);
  end
  lost = setdiff (given.bench(isAsked), given.bench(hasNeighbour));
  if ~isempty (lost)
    notes = {['optim.correlation has no effect, for no two results are ' ...
              'measured, fitted and on one series (results.csv: series, ' ...
              'at), of ', strjoin(given.benchNames(lost), ', ')]};
  end
end

%!shared given, targets
%! given = struct ('value', [1, 1, 1, 1], 'held', false (1, 4), ...
%!                 'sd', [1, 2, 2, 1], 'series', [1, 1, 0, 0], ...
%!                 'coordinate', [10, 15, 0, 0], 'bench', [1, 1, 1, 2], ...
%!                 'benchNames', {{'A', 'B'}});
%! targets = struct ('correlation', {5, 5, 5, NaN});
%!test
%! [out, notes] = addCorrelation (given, targets);
%! C = diag ([1, 4, 4, 1]);
%! C(1, 2) = C(2, 1) = 2 / e;
%! assert (out.covariance, C, 1e-5);
%! assert (out.estimateSeries, false (1, 4));
%! assert (numel (notes), 1);
%! assert (! isempty (regexp (notes{1}, 'optim.correlation .* of B$')));
%!test
%! % to be estimated: no covariance yet
%! [targets(1:3).correlation] = deal (NaN);
%! [targets(4).correlation] = 0;
%! [out, notes] = addCorrelation (given, targets);
%! assert (isfield (out, 'covariance'), false);
%! assert (out.estimateSeries, [true, true, false, false]);
%! assert (isempty (notes));
%!test
%! % a neighbour that is not measured, or held out, tells no length
%! [targets(1:3).correlation] = deal (NaN);
%! given.value(2) = NaN;
%! assert (addCorrelation (given, targets).estimateSeries, false (1, 4));
%! [given.value(2), given.held(2)] = deal (1, true);
%! [out, notes] = addCorrelation (given, targets);
%! assert (out.estimateSeries, false (1, 4));
%! assert (numel (notes), 1);
%!assert (isfield (addCorrelation (given, struct ('correlation', {0, 0, ...
%!                                                0, 0})), 'covariance'), false)
