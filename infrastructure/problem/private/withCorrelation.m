% WITHCORRELATION  Errors that are alike along a series, as a covariance.
%
% CALL: [GIVEN, NOTE] = withCorrelation (GIVEN)
%
%   GIVEN  struct of newProblem: correlation, shared, series, coordinate, sd ...
%          comes back with covariance (T x T, or []) and estimateSeries (1 x T
%          logical: its length is to be estimated)
%   NOTE   cellstr, benches on which a length means nothing
%
% Errors that are alike along a series of results.csv (optim.correlation), or
% that its sessions share, make the covariance. A length means nothing where the
% target has no neighbour on its series.

function [given, note] = withCorrelation (given)
  note = {};
  lengths = given.correlation;
  isAsked = lengths ~= 0;
  % a length is learned from what is measured and fitted
  counts = isAsked & ~(isnan (lengths) & (isnan (given.value) | given.held));
  together = given.series' == given.series & given.series > 0 & ...
             counts' & isAsked;
  hasNeighbour = sum (together) > 1;
  given.estimateSeries = hasNeighbour & isnan (lengths);
  lengths(~hasNeighbour | isnan (lengths)) = 0;
  given.covariance = [];
  if any (lengths > 0 | given.shared > 0)
    given.covariance = measurementCovariance (given.sd, given.series, ...
                                              given.coordinate, lengths, ...
                                              given.shared);
  end
  lost = setdiff (given.bench(isAsked), given.bench(hasNeighbour));
  if ~isempty (lost)
    note = {['optim.correlation has no effect, for no two results are ' ...
             'measured, fitted and on one series (results.csv: series, ' ...
             'at), of ', strjoin(given.benchNames(lost), ', ')]};
  end
end

%!test
%! % three on a curve, of which one is not measured: the others tell the length
%! given = struct ('value', [1, NaN, 1, 1], 'held', false (1, 4), 'sd', ...
%!                 [1, 2, 2, 1], 'series', [1, 1, 1, 0], 'coordinate', ...
%!                 [0, 5, 5, 0], 'correlation', [NaN, NaN, NaN, NaN], ...
%!                 'shared', zeros (1, 4), 'bench', [1, 1, 1, 2], ...
%!                 'benchNames', {{'A', 'B'}});
%! [found, note] = withCorrelation (given);
%! assert (found.estimateSeries, [true, true, true, false]);
%! assert (isempty (found.covariance));
%! assert (note, {['optim.correlation has no effect, for no two results are ', ...
%!                 'measured, fitted and on one series (results.csv: series, ', ...
%!                 'at), of B']});
%! given.correlation = [5, 5, 5, 0];
%! assert (withCorrelation (given).covariance(1, 2:4), [2/e, 2/e, 0], 1e-5);

% SPDX-License-Identifier: GPL-3.0-only
