% TARGETCURVE  Figure of a measured curve and what the found set gives.
%
% CALL: F = targetCurve (PAGE, OWN)
%
%   PAGE  see pageData
%   OWN   1 x n, numbers of the targets that are its points
%   F     see newFigure
%
% See also: sectionTargets, curveSummary

function f = targetCurve (page, own)
  T = page.Case.targets(own);
  [at, order] = sort ([T.at]);
  own = own(order);
  T = T(order);
  read = @(field) arrayfun (@(t) jsonAt (page.sources.calibration, ...
                                         {'targets', t, field}), own)';
  result = read ('result');
  half = arrayfun (@halfWidth, T)';
  value = [T.value]';
  alt = sprintf ('%s: measured and found at %d points, from %.4g and %.4g', ...
                 T(1).series, numel (own), value(1), result(1));
  alt = sprintf ('%s to %.4g and %.4g', alt, value(end), result(end));
  f = newFigure (sprintf ('%s: %s', T(1).modelName, T(1).series), ...
                 'where it was measured', page.units{own(1)}, alt);
  at = at(:);
  f = addLayer (f, 'area', [at, value - half, value + half], 'palegreen');
  if isfield (jsonAt (page.sources.calibration, {'targets', own(1)}), ...
              'interval90')
    inner = arrayfun (@(t) jsonAt (page.sources.calibration, ...
                                   {'targets', t, 'interval90'})(:)', own, ...
                      'UniformOutput', false);
    f = addLayer (f, 'area', [at, vertcat(inner{:})], 'midblue');
  end
  f = addLayer (f, 'line', [at, result], 'blue');
  f = addLayer (f, 'dots', [at, value], 'ink');
end

%!test
%! page.Case.targets = struct ('at', {2, 1}, 'value', {4, 3}, 'tol', 0.1, ...
%!                             'series', 'w', 'modelName', 'A');
%! page.units = {'kg', 'kg'};
%! page.sources.calibration.targets = struct ('result', {4.1, 2.9}, ...
%!                                            'interval90', {[4; 5], [2; 3]});
%! f = targetCurve (page, [1, 2]);
%! assert ({f.layers.kind}, {'area', 'area', 'line', 'dots'});
%! assert (f.layers(3).data, [1, 2.9; 2, 4.1]);
%! assert (f.layers(2).data, [1, 2, 3; 2, 4, 5]);
