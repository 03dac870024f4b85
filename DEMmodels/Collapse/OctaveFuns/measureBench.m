% MEASUREBENCH  Reads packing, profile and spreading of a collapsed column.
%
% CALL: RESULTS = measureBench (FOLDER)
%
% FOLDER   folder of a finished run
% RESULTS  scalar struct, a field per result of results.csv; no fields if the
%          run is not sane, or if more than single grains have reached the stop
%          at the end of the floor
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
  L0 = checks.columnLength;
  column = readDump (fullfile (folder, 'column.dump')){end};
  deposit = readDump (fullfile (folder, 'deposit.dump')){end};

  d = 2 * median (deposit(:, 4));
  inside = linspace (d, L0 - d, 60);
  columnTop = mean (silhouette (column, inside));
  front = frontOf (deposit(:, 1));
  if front > checks.runway - 2 * d
    return
  end
  stations = linspace (0.2 * front, 0.8 * front, 60);
  profile = silhouette (deposit, stations);
  known = ~isnan (profile);
  line = polyfit (stations(known), profile(known), 1);

  results.bulkDensity = checks.massStart / ...
                        (L0 * checks.columnWidth * columnTop);
  results.runOut = front - L0;
  results.heightBack = meanTop (deposit, d / 2, L0 / 2);
  results.heightFoot = meanTop (deposit, L0, 1.5 * L0);
  results.slope = atand (-line(1));
  results.spreadTime = spreadTime (fullfile (folder, 'spread.csv'));
end

% 97 % of the grains lie behind the front: single rollers do not count
function front = frontOf (x)
  x = sort (x);
  front = interp1 ((1:numel (x)).' / numel (x), x, 0.97);
end

function height = meanTop (grains, from, to)
  height = silhouette (grains, linspace (from, to, 40));
  height(isnan (height)) = 0;
  height = mean (height);
end

% when the mean position has covered 90 % of its way
function seconds = spreadTime (file)
  curve = dlmread (file, ',', 1, 0);
  share = (curve(:, 2) - curve(1, 2)) / (curve(end, 2) - curve(1, 2));
  k = find (share >= 0.9, 1);
  part = (0.9 - share(k - 1)) / (share(k) - share(k - 1));
  seconds = curve(k - 1, 1) + part * (curve(k, 1) - curve(k - 1, 1));
end
