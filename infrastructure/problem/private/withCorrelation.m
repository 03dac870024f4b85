% WITHCORRELATION  Errors that are alike along a series, as a covariance.
%
% CALL: [GIVEN, NOTE] = withCorrelation (GIVEN)
%
%   GIVEN  struct of newProblem: correlation, shared, series, coordinate, sd, and
%          errors (1 x T cell, of alikeTrials) ...; comes back without these, with
%          covariance (T x T, or []) and estimateSeries (1 x T
%          logical: its length is to be estimated)
%   NOTE   cellstr, benches on which a length means nothing
%
% Errors that are alike along a series of results.csv (optim.correlation), or
% that its sessions share, make the covariance, and trials that err alike in several
% readings, as far as chance does not make it (alikeTrials). A length means nothing where the
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
  likeness = likenessOf (given);
  if any (lengths > 0 | given.shared > 0) || any (likeness(:))
    given.covariance = measurementCovariance (given.sd, given.series, ...
                                              given.coordinate, lengths, ...
                                              given.shared);
    own = sqrt (max (given.sd.^2 - given.shared.^2, 0));
    given.covariance = given.covariance + (own' * own) .* likeness;
  end
  given = rmfield (given, intersect (fieldnames (given), {'errors'}));
  lost = setdiff (given.bench(isAsked), given.bench(hasNeighbour));
  if ~isempty (lost)
    note = {['optim.correlation has no effect, for no two results are ' ...
             'measured, fitted and on one series (results.csv: series, ' ...
             'at), of ', strjoin(given.benchNames(lost), ', ')]};
  end
end

% Correlations off the diagonal, T x T.
function R = likenessOf (given)
  T = numel (given.sd);
  R = zeros (T);
  groups = zeros (1, T);
  errors = givenField (given, 'errors', cell (1, T));
  isThere = ~cellfun (@isempty, errors);
  if ~any (isThere)
    return
  end
  groups(isThere) = cellfun (@(e) e.group, errors(isThere)) .* given.scatter(isThere);
  for group = setdiff (groups, 0)
    at = find (groups == group);
    same = [errors{at}];
    z = vertcat (same.z);
    own = z * z' .* ~eye (numel (at));
    squares = sumsq (own(:)) / max (numel (at) * (numel (at) - 1), 1);
    chance = 1 / same(1).df;
    R(at, at) = own * max (1 - chance / max (squares, realmin), 0) / (1 - chance);
  end
end

%!test
%! % trials that err alike in two of three readings
%! e = @(z, group) struct ('z', z, 'df', 4, 'group', group);
%! z = [1, -1, 1, -1] / 2;
%! given = struct ('value', [1, 1, 1], 'held', false (1, 3), 'sd', [1, 2, 3], 'series', ...
%!                 [0, 0, 0], 'coordinate', zeros (1, 3), 'correlation', zeros (1, 3), ...
%!                 'shared', [0, 0, 0], 'bench', [1, 1, 2], 'scatter', true (1, 3), ...
%!                 'errors', {{e(z, 1), e(-z, 1), e(z, 0)}});
%! given.benchNames = {'A', 'B'};
%! found = withCorrelation (given);
%! assert (found.covariance, [1, -2, 0; -2, 4, 0; 0, 0, 9], 1e-4);
%! given.errors{2}.z = [1, 1, -1, -1] / 2;
%! assert (isempty (withCorrelation (given).covariance));
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
