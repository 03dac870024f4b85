% MEASUREBENCH  Reads the free surface of a turning drum at three speeds.
%
% CALL: RESULTS = measureBench (FOLDER)
%
% FOLDER   folder of a finished run
% RESULTS  scalar struct, a field per result of results.csv; no fields if the
%          run is not sane
%
% The silhouette of the bed, averaged over the frames of a stage, is fitted
% for |x| < 0.6 R by z = a + b x + c x^2: height a, slope atan (|b|), curvature
% 2 c / (1 + b^2)^(3/2).
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
  for k = 1:3
    frames = readDump (fullfile (folder, sprintf ('surface%d.dump', k)));
    row = surfaceOf (frames, checks.drumRadius);
    results.(sprintf ('slope%d', k)) = row(1);
    results.(sprintf ('curvature%d', k)) = row(2);
    results.(sprintf ('height%d', k)) = row(3);
  end
end

function row = surfaceOf (frames, radius)
  x = linspace (-0.6, 0.6, 49) * radius;
  heights = cellfun (@(grains) silhouette (grains, x).', frames, ...
                     'UniformOutput', false);
  heights = [heights{:}];
  known = ~isnan (heights);
  heights(~known) = 0;
  z = (sum (heights, 2) ./ sum (known, 2)).';
  p = polyfit (x, z, 2);
  b = abs (p(2));
  row = [atand(b), 2 * p(1) / (1 + b^2)^1.5, p(3)];
end
