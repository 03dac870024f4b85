% GETRESULTS  Read the two results of a finished run of the container Lift100.
%
% CALL: res = getResults (model, folderName)
%
%   model        text: name of the model folder
%   folderName   text: name of the run's folder below optim/<model>
%   res          1 x 2 cell of scalars: bulk density of the filling (kg/m3),
%                mass that stays in the container after the discharge (kg)
%
% A result is NaN when its file is missing or holds no number, and when the
% counts of spheres do not agree: fewer than 2 % above the filling height
% (the density would be that of a half filled container), or spheres lost.
% The global variable path holds the working folder with a slash at its end.
%
% See also: DEcalioc, loadInput

function res = getResults (model, folderName)

  %| pragma Justify (metric, "globals", "the published interface of models");
  global path
  folder = [path, 'optim/', model, '/', folderName, '/'];
  checks = readChecks ([folder, 'output_checks.csv']);
  res = {readScalar([folder, 'output_density']), ...
         readScalar([folder, 'output_mass'])};

  if ~(checks.spheresKept <= 0.98 * checks.spheresFilled)
    res{1} = NaN;
  end
  if ~(checks.spheresOut + checks.spheresEnd == checks.spheresKept)
    res{2} = NaN;
  end

end

% One number in a file; NaN when there is none, or more than one.
function value = readScalar (file)

  value = NaN;
  if exist (file, 'file') == 2
    value = str2double (strtrim (fileread (file)));
  end

end

% Lines "name,number" into a struct; a count that is not there is NaN.
function checks = readChecks (file)

  checks = struct ('spheresFilled', NaN, 'spheresKept', NaN, ...
                   'spheresOut', NaN, 'spheresEnd', NaN);
  if exist (file, 'file') ~= 2
    return
  end
  found = regexp (fileread (file), '^(\w+),(\S+)$', 'tokens', ...
                  'lineanchors');
  for k = 1:numel (found)
    checks.(found{k}{1}) = str2double (found{k}{2});
  end

end
