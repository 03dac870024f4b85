% MEASUREBENCH  Reads discharge and residual slope of the two slot bins.
%
% CALL: RESULTS = measureBench (FOLDER)
%
% FOLDER   folder of a finished run
% RESULTS  scalar struct, a field per result of results.csv; no fields if the
%          run is not sane
%
% The rate is taken between 20 and 70 % of what leaves; 0 where nothing does.
%
% Throws what readChecks and readDump throw for a missing file.
%
% See also: readDump, silhouette, readChecks
function results = measureBench (folder)
  results = struct ();
  checks = readChecks (folder);
  if ~checks.sane
    return
  end
  flow = dlmread (fullfile (folder, 'flow.csv'), ',', 1, 0);
  grains = readDump (fullfile (folder, 'rest.dump')){end};
  left = grains(grains(:, 1) < 0, :);
  left(:, 1) = -left(:, 1);
  right = grains(grains(:, 1) > 0, :);
  results.rate1 = rateOf (flow(:, 1), flow(:, 2));
  results.remaining1 = flow(end, 2);
  results.slope1 = slopeOf (left, -checks.plateL, checks.binLength);
  results.rate2 = rateOf (flow(:, 1), flow(:, 3));
  results.remaining2 = flow(end, 3);
  results.slope2 = slopeOf (right, checks.plateR, checks.binLength);
end

function rate = rateOf (time, mass)
  gone = mass(1) - mass;
  total = gone(end);
  if total <= 0
    rate = 0;
    return
  end
  from = find (gone >= 0.2 * total, 1);
  to = find (gone >= 0.7 * total, 1);
  rate = (gone(to) - gone(from)) / (time(to) - time(from));
end

function slope = slopeOf (grains, edge, wall)
  d = 2 * median (grains(:, 4));
  x = linspace (edge + d, wall - d, 40);
  z = silhouette (grains, x);
  z(isnan (z)) = 0;
  line = polyfit (x, z, 1);
  slope = atand (line(1));
end
