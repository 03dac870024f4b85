% GETRESULTS  Results of a run of the model @MODEL@.
%
% CALL: RES = getResults (MODEL, FOLDERNAME)
%
%   MODEL       name of the model's folder below optim/ (text)
%   FOLDERNAME  name of the run's folder (text)
%   RES         1 x 3 cell of scalars, in the order of results.csv: angle of
%               repose (deg), mass on the plate (kg), height of the apex (m);
%               NaN where a file is missing or the run is not sane
%
% Leaves the picture measured.svg in the run's folder: the heap from the side,
% and the line that was fitted to it.
%
% See also: readDump, coneLine, readChecks

function res = getResults (model, folderName)
  %| pragma Justify (metric, "globals", "the way in that runs have");
  global path
  res = num2cell (NaN (1, 3));
  folder = [path, 'optim/', model, '/', folderName, '/'];
  try
    checks = readChecks (folder);
    if checks.sane
      res = num2cell (measure (folder, checks));
    end
  catch err
    % a run that broke off has no files: its results are NaN
    printf ('getResults: %s\n', err.message);
  end
end

function results = measure (folder, checks)
  grains = readDump ([folder, 'heap.dump']){end};
  grains = grains(grains(:, 3) > 0, :);
  R = checks.plateRadius;
  [angle, apex, points] = coneLine (grains, 0.2 * R, 0.8 * R);
  share = rows (grains) / checks.spheresStart;
  mass = checks.massStart * share;
  results = [angle, mass, apex];

  % the cone that was fitted, from the side
  r = [-points(1, end:-1:1), 0, points(1, :)];
  line = [r; apex - abs(r) * tand(angle)];
  drawSideView ([folder, 'measured.svg'], grains, line, ...
                sprintf ('angle of repose %.1f deg', angle));
end
