% MEASUREBENCH  Reads the deposit of a collapsed column of beads.
%
% CALL: RESULTS = measureBench (FOLDER)
%
% FOLDER   folder of a finished run
% RESULTS  scalar struct, a field per result of results.csv; no fields if the
%          run is not sane
%
% The surface is what a camera sees from the side: the highest bead above a
% place, mean over one diameter. profile: places over the length of the tank
% from the end wall, surface over the height of the column before it fell, as
% the picture shows it: from slightly above, so that beads on the floor read
% 0.05 too high; bare floor reads 0. The angles are least squares slopes of the
% surface: at the top where it lies between 0.5 and 0.95 of its highest value,
% at the toe between 0.15 and 0.42. The length ends at the last place that is
% higher than one layer and a quarter.
% timeRest: when the mean kinetic energy last exceeds 0.001 m g r.
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
  column = readDump (fullfile (folder, 'column.dump')){end};
  deposit = readDump (fullfile (folder, 'deposit.dump')){end};
  d = 2 * median (deposit(:, 4));
  L0 = checks.columnLength;
  before = mean (surface (column, linspace (d, L0 - d, 60), d));

  at = 0.01:0.01:0.99;
  x = at * checks.tankLength;
  [z, share] = surface (deposit, x, d);
  peak = max (z(at >= 0.04 & at <= 0.25));
  results.profile = [at; z / before + 0.05 * share .* (1 - z / before)].';
  results.topAngle = slope (x, z, 0.5 * peak, 0.95 * peak);
  results.toeAngle = slope (x, z, 0.15 * peak, 0.42 * peak);
  results.length = 100 * x(find (z > 1.25 * d, 1, 'last'));
  results.height = 100 * peak;
  curve = dlmread (fullfile (folder, 'spread.csv'), ',', 1, 0);
  results.timeRest = curve(find (curve(:, 3) > 0.001, 1, 'last'), 1);
end

% highest bead, mean over one diameter about each place; bare floor is 0. SHARE
% of the diameter in which there are beads.
function [z, share] = surface (grains, x, d)
  places = x + linspace (-d / 2, d / 2, 9).';
  z = silhouette (grains, places(:).');
  z = reshape (z, 9, []);
  bare = isnan (z);
  z(bare) = 0;
  z = mean (z, 1);
  share = 1 - mean (bare, 1);
end

function angle = slope (x, z, from, to)
  own = x > 0.03 & z >= from & z <= to;
  angle = NaN;
  if sum (own) > 2
    angle = -atand (polyfit (x(own), z(own), 1)(1));
  end
end
