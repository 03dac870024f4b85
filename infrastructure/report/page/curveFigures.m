% CURVEFIGURES  Measured against simulated, a figure a curve.
%
% CALL: FIGURES = curveFigures (PAGE, WHERE)
%
%   PAGE     see pageData; its gapTargets give values and noise
%   WHERE    where of gap.json
%   FIGURES  1 x n struct array, see newFigure; [] without gap/targets.csv
%
% Results of one series (results.csv of the model) are a curve over where they
% were measured; single targets stand in benchFigure.
%
% See also: sectionWhere, targetInfo

function figures = curveFigures (page, where)
  figures = [];
  table = page.sources.gapTargets;
  if ~isfield (table, {'model', 'target', 'measured', 'predicted'})
    return
  end
  benches = unique ({table.model}, 'stable');
  for b = 1:numel (benches)
    mine = table(strcmp ({table.model}, benches{b}));
    [series, at, unit] = seriesOf (page.Case, benches{b}, mine);
    for name = unique (series(~cellfun (@isempty, series)))
      points = find (strcmp (series, name{1}) & isfinite (at));
      if numel (points) > 2
        figures = [figures, curve(mine(points), at(points), ...
                                  sprintf ('%s: %s', benches{b}, name{1}), ...
                                  unit{points(1)})];
      end
    end
  end
end

function [series, at, unit] = seriesOf (Case, bench, mine)
  series = repmat ({''}, 1, numel (mine));
  at = NaN (1, numel (mine));
  unit = series;
  k = find (strcmp (bench, {Case.models.name}), 1);
  if isempty (k)
    return
  end
  isOwn = [Case.targets.model] == k;
  info = targetInfo (Case)(isOwn);
  own = Case.targets(isOwn);
  for i = 1:numel (mine)
    t = find (strcmp (mine(i).target, {own.name}), 1);
    if ~isempty (t)
      r = info(t);
      series{i} = r.series;
      at(i) = r.at;
      unit{i} = strrep (r.unit, '-', '');
    end
  end
end

function f = curve (points, at, title, unit)
  [at, order] = sort (at);
  points = points(order);
  measured = [points.measured]';
  simulated = [points.predicted]';
  sd = [points.sd_measured]';
  noise = 1.64 * hypot ([points.sd_trial]', [points.sd_surrogate]');
  alt = sprintf ('%s: measured and simulated at %d points', title, ...
                 numel (at));
  f = newFigure (title, 'where it was measured', unit, alt);
  at = at(:);
  f = addLayer (f, 'area', [at, simulated - noise, simulated + noise], ...
                'paleblue');
  f = addLayer (f, 'line', [at, simulated], 'blue');
  f = addLayer (f, 'ybar', [at, measured, measured - sd, measured + sd], ...
                'ink');
end
