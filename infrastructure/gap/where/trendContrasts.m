% TRENDCONTRASTS  Tests residuals along speed, time or opening.
%
% CALL: TRENDS = trendContrasts (GAPPROBLEM, TARGETS, R, OMEGA)
%
%   GAPPROBLEM  struct of newGapProblem (series, coordinate)
%   TARGETS     1 x n, targets of R
%   R           n x 1, residuals (raw units);  OMEGA  n x n, their covariance
%   TRENDS      1 x s struct, one a series of three or more targets: series,
%               targets, coordinate, t (1 x 3: level, slope, curvature in units
%               of their standard deviation)
%
% A gap that grows with speed points elsewhere than one that is flat.
%
% See also: locateGap

function trends = trendContrasts (gapProblem, targets, r, Omega)
  trends = struct ('series', {}, 'targets', {}, 'coordinate', {}, 't', {});
  series = gapProblem.series(targets);
  for s = unique (series(series > 0))
    at = find (series == s);
    coordinate = gapProblem.coordinate(targets(at));
    x = coordinate';
    if numel (unique (x)) < 3
      continue
    end
    x = (x - mean (x)) / std (x);
    [C, ~] = qr ([ones(numel (x), 1), x, x.^2], 0);
    C = C .* sign (sum (C .* [ones(numel (x), 1), x, x.^2], 1));
    spread = sqrt (max (diag (C' * Omega(at, at) * C), eps));
    trends(end + 1) = struct ('series', s, 'targets', targets(at), ...
                              'coordinate', coordinate, ...
                              't', ((C' * r(at)) ./ spread)');
  end
end

%!test
%! gapProblem = struct ('series', [1, 1, 1, 0], 'coordinate', [10, 30, 50, 0]);
%! trends = trendContrasts (gapProblem, 1:4, [-1; 0; 1; 9], eye (4));
%! assert (numel (trends), 1);
%! assert (trends.t, [0, sqrt(2), 0], 1e-12);
