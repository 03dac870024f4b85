% TRENDCONTRASTS  Tests residuals along speed, time or opening.
%
% CALL: TRENDS = trendContrasts (GAPPROBLEM, TARGETS, R, VIEW)
%
%   GAPPROBLEM  struct of newGapProblem (series, coordinate)
%   TARGETS     1 x n, targets of R
%   R           n x 1, residuals
%   VIEW        struct Omega, Sigma (n x n): covariance of R, and before the fit
%   TRENDS      1 x s struct, one a series of three or more targets: series,
%               targets, coordinate, t (1 x 3: level, slope, curvature in units
%               of their standard deviation)
%
% A gap that grows with speed points elsewhere than one that is flat.
%
% See also: locateGap

function trends = trendContrasts (gapProblem, targets, r, view)
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
    spread = sqrt (max (diag (C' * view.Omega(at, at) * C), ...
                        1e-3 * diag (C' * view.Sigma(at, at) * C)));
    trends(end + 1) = struct ('series', s, 'targets', targets(at), ...
                              'coordinate', coordinate, ...
                              't', ((C' * r(at)) ./ spread)');
  end
end

%!test
%! gapProblem = struct ('series', [1, 1, 1, 0], 'coordinate', [10, 30, 50, 0]);
%! view = struct ('Omega', eye (4), 'Sigma', eye (4));
%! trends = trendContrasts (gapProblem, 1:4, [-1; 0; 1; 9], view);
%! assert (numel (trends), 1);
%! assert (trends.t, [0, sqrt(2), 0], 1e-12);
