% GETRESULTS  Results of a run of the model @MODEL@.
%
% CALL: RES = getResults (MODEL, FOLDERNAME)
%
%   MODEL       name of the model's folder below optim/ (text)
%   FOLDERNAME  name of the run's folder
%   RES         1 x n cell, the results that results.csv lists, in its order;
%               NaN where a file is missing or the run is not sane
%
% Leaves the picture measured.svg in the run's folder: the heap from the side,
% and the line that was fitted to it.
%
% See also: readDump, coneLine, readChecks

function res = getResults (model, folderName)
  %| pragma Justify (metric, "globals", "the way in that runs have");
  global path
  names = {resultInfo(fileparts (fileparts (mfilename ('fullpath')))).name};
  res = num2cell (NaN (1, numel (names)));
  folder = [path, 'optim/', model, '/', folderName, '/'];
  try
    checks = readChecks (folder);
    if checks.sane
      found = measure (folder, checks);
      res = cellfun (@(name) found.(name), names, 'UniformOutput', false);
    end
  catch err
    % a run that broke off has no files: its results are NaN
    printf ('getResults: %s\n', err.message);
  end
end

% One field a result, named as in results.csv: a number, or a curve of two
% columns (place, value).
function found = measure (folder, checks)
  grains = readDump ([folder, 'heap.dump']){end};
  grains = grains(grains(:, 3) > 0, :);
  R = checks.plateRadius;
  [angle, apex, points] = coneLine (grains, 0.2 * R, 0.8 * R);
  share = rows (grains) / checks.spheresStart;
  found.('angle of repose') = angle;                    % deg
  found.('mass on plate') = checks.massStart * share;   % kg
  found.('apex height') = apex;                         % m
  found.profile = points';                % m, distance from the axis and height

  % the cone that was fitted, from the side
  r = [-points(1, end:-1:1), 0, points(1, :)];
  line = [r; apex - abs(r) * tand(angle)];
  drawSideView ([folder, 'measured.svg'], grains, line, ...
                sprintf ('angle of repose %.1f deg', angle));
end
