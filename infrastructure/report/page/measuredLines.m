% MEASUREDLINES  Measured inclinations as lines in a picture of grains.
%
% CALL: LINES = measuredLines (CASE, K, FILE, LEFT, GRAINS)
%
%   CASE    see newCase
%   K       number of the model; its results.csv says which results are angles
%   FILE    name of the dump; a number at its end picks the angle of that number
%           among those of results.csv, whether the others were measured or not
%   LEFT    dumps of the run that come after this one; without numbers only the
%           last one gets lines
%   GRAINS  n x 4, columns x y z radius
%   LINES   1 x m cell of 2 x 2 or 3 x 2 (x, z)
%
% Each line goes through the middle of the free surface it belongs to and falls
% to the same side: measured angles are given without a sign. Of two angles in
% one picture the first belongs to the left half, the second to the right one.
% The line of a cone has two sides and its apex at the measured height, where
% that is a target.

function lines = measuredLines (Case, k, file, left, grains)
  lines = {};
  [kinds, values, apex, places, count] = anglesOf (Case, k);
  [~, base] = fileparts (file);
  number = str2double (regexp (base, '\d+$', 'match', 'once'));
  if number >= 1 && number <= count
    kinds = kinds(places == number);
    values = values(places == number);
  elseif left > 0
    return
  end
  ends = [min(grains(:, 1)), max(grains(:, 1))];
  for i = 1:numel (values)
    span = ends;
    if numel (values) == 2
      span(3 - i) = mean (ends);
    end
    lines{end + 1} = lineOf (kinds{i}, values(i), span, grains, apex);
  end
end

% PLACES: their numbers among the COUNT angles of results.csv.
function [kinds, values, apex, places, count] = anglesOf (Case, k)
  kinds = {};
  [values, places] = deal ([]);
  apex = NaN;
  known = resultInfo (Case.models(k).folder);
  if isempty (known)                    % a model without results.csv
    known = {};
  else
    isAngle = ismember ({known.kind}, {'angle', 'angleFalling', 'coneAngle'});
    known = {known(isAngle).name};
  end
  count = numel (known);
  info = targetInfo (Case);
  for t = find ([Case.targets.model] == k)
    T = Case.targets(t);
    kind = info(t).kind;
    if any (strcmp (kind, {'angle', 'angleFalling', 'coneAngle'}))
      kinds{end + 1} = kind;
      values(end + 1) = T.value;
      name = givenField (T, 'result', info(t).name);
      place = [find(strcmp (known, name)), NaN];
      places(end + 1) = place(1);
    elseif strcmp (kind, 'height') && info(t).at == 0
      apex = T.value;
    end
  end
end

function line = lineOf (kind, degrees, span, grains, apex)
  x = linspace (span(1), span(2), 60);
  z = silhouette (grains, x);
  % single grains on the floor are no surface
  ground = min (grains(:, 3)) + 2 * median (grains(:, 4));
  onBed = z > ground;
  if sum (onBed) < 5
    onBed = isfinite (z);
  end
  x = x(onBed)';
  z = z(onBed)';
  slope = tand (degrees);
  middle = mean (x);
  if strcmp (kind, 'coneAngle')
    middle = mean (span);
    if isnan (apex)
      apex = max (z);
    end
    x = [x(1); middle; x(end)];
    line = [x, apex - slope * abs(x - middle)];
    return
  end
  % results are given without a sign: it is that of the surface
  fitted = polyfit (x - middle, z, 1);
  slope = slope * sign (fitted(1) + eps);
  x = x([1; end]);
  line = [x, mean(z) + slope * (x - middle)];
end

%!test
%! % a ramp of touching grains: the line follows it, whatever the sign
%! folder = emptyFolder ();
%! writeAtomic (fullfile (folder, 'results.csv'), ...
%!   ["name,kind,unit,series,at,text\nh,mass,kg,,,\n", ...
%!    "s1,angle,deg,,,\ns2,angleFalling,deg,,,\n"]);
%! Case.models = struct ('folder', folder);
%! Case.targets = struct ('model', 1, 'index', {1, 2, 3}, 'value', ...
%!                        {5, 45, 30});
%! x = (0:0.5:10)';
%! grains = [x, 0 * x, 20 - 2 * x, 1 + 0 * x];
%! lines = measuredLines (Case, 1, 'rest.dump', 0, grains);
%! assert (numel (lines), 2);
%! assert (diff (lines{1}(:, 2)), -diff (lines{1}(:, 1)), 1e-12);
%! assert (all (lines{1}(:, 1) <= 5) && all (lines{2}(:, 1) >= 5));
%! lines = measuredLines (Case, 1, 'surface2.dump', 3, grains);
%! assert (numel (lines), 1);
%! assert (diff (lines{1}(:, 2)) / diff (lines{1}(:, 1)), -tand (30), 1e-12);
%! assert (isempty (measuredLines (Case, 1, 'column.dump', 1, grains)));
%! % of the second angle alone: its line lies in its picture, and in no other one
%! Case.targets = mergeFields (Case.targets(3), struct ('result', 's2', 'name', 's2', ...
%!                             'series', '', 'unit', '', 'at', NaN));
%! assert (isempty (measuredLines (Case, 1, 'surface1.dump', 0, grains)));
%! assert (numel (measuredLines (Case, 1, 'surface2.dump', 0, grains)), 1);

% SPDX-License-Identifier: GPL-3.0-only
