% MEASUREBENCH  Reads the free surface of a turning drum at two speeds.
%
% CALL: RESULTS = measureBench (FOLDER)
%
% FOLDER   folder of a finished run
% RESULTS  scalar struct: surfaceSlow and surfaceFast (n x 2: x and z in mm from
%          the axis of the drum, z up, the bed climbs towards negative x),
%          slopeSlow and slopeFast (deg); no fields if the run is not sane
%
% As the instrument reads its averaged picture: a point of the picture is
% occupied for that share of the frames in which a grain covers it, seen along
% the axis. The surface is where the share falls through 0.5 on the way up, at
% stations 0.5 mm apart; each value of the curve is the mean of the stations
% within 1 mm. Where the mantle lies bare, the mantle is the surface.
%
% Throws what readChecks and readDump throw for a missing file.
%
% See also: readDump, readChecks
function results = measureBench (folder)
  results = struct ();
  checks = readChecks (folder);
  if ~checks.sane
    return
  end
  for name = {'Slow', 'Fast'}
    frames = readDump (fullfile (folder, ['surface', name{1}, '.dump']));
    curve = surfaceOf (frames, checks.drumRadius);
    results.(['surface', name{1}]) = curve;
    results.(['slope', name{1}]) = slopeOf (curve);
  end
end

function curve = surfaceOf (frames, radius)
  x = (-29:0.5:29) * 1e-3;
  step = 1e-4;
  edges = -radius:step:radius;
  share = zeros (numel (edges), numel (x));
  for k = 1:numel (frames)
    share = share + covered (frames{k}, x, edges(1), size (share), step);
  end
  share = share / numel (frames);
  z = arrayfun (@(j) crossing (share(:, j), edges, step), 1:numel (x));
  isBare = isnan (z);
  z(isBare) = -sqrt (radius^2 - x(isBare).^2);
  z = conv (z, ones (1, 5) / 5, 'valid');
  curve = 1e3 * [x(3:end - 2); z].';
end

% Pixels (rows along z, columns along x) that some grain covers.
function isCovered = covered (grains, x, bottom, shape, step)
  chord2 = grains(:, 4).^2 - (x - grains(:, 1)).^2;
  [i, j] = find (chord2 > 0);
  half = sqrt (chord2(chord2 > 0));
  row = @(z) min (max (round ((z - bottom) / step) + 1, 1), shape(1));
  enters = accumarray ([row(grains(i, 3) - half), j], 1, shape);
  leaves = accumarray ([row(grains(i, 3) + half), j], 1, shape);
  isCovered = cumsum (enters - leaves, 1) > 0;
end

% The highest place where the share falls through one half.
function z = crossing (share, edges, step)
  below = find (share >= 0.5, 1, 'last');
  z = NaN;
  if ~isempty (below) && below < numel (share)
    part = (share(below) - 0.5) / (share(below) - share(below + 1));
    z = edges(below) + step * (part + 0.5);
  end
end

function slope = slopeOf (curve)
  own = abs (curve(:, 1)) <= 8.4;
  p = polyfit (curve(own, 1), curve(own, 2), 1);
  slope = atand (abs (p(1)));
end
