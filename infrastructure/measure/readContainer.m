% READCONTAINER  Reads density and remaining mass of a container's discharge.
%
% CALL: RES = readContainer (FOLDER)
%
%   FOLDER  folder of a finished run of Lift100 or SmallBin (text)
%   RES     1 x 2 cell of scalars: bulk density of the filling (kg/m3), mass
%           that stays after the discharge (kg)
%
% A result is NaN when its file is missing or holds no number, and when the
% counts of spheres do not agree: fewer than 2 % above the filling height
% (the density would be that of a half filled container), or spheres lost.
%
% See also: readResults, readChecks

function res = readContainer (folder)
  textOf = @(name) readText (fullfile (folder, name));
  checks = textOf ('output_checks.csv');
  count = @(name) str2double ([regexp(checks, ['^', name, ',(\S+)$'], ...
                                      'tokens', 'once', 'lineanchors'){:}]);
  res = {str2double(strtrim (textOf ('output_density'))), ...
         str2double(strtrim (textOf ('output_mass')))};
  kept = count ('spheresKept');
  if ~(kept <= 0.98 * count ('spheresFilled'))
    res{1} = NaN;
  end
  if ~(count ('spheresOut') + count ('spheresEnd') == kept)
    res{2} = NaN;
  end
end

%!test
%! [folder, put] = emptyFolder ();
%! assert (readContainer (folder), {NaN, NaN});
%! put ('output_density', "400\n");
%! put ('output_mass', "0.025\n");
%! put ('output_checks.csv', ["spheresFilled,100\nspheresKept,90\n", ...
%!                            "spheresOut,60\nspheresEnd,30\n"]);
%! assert (readContainer (folder), {400, 0.025});
%! put ('output_checks.csv', ["spheresFilled,100\nspheresKept,99\n", ...
%!                            "spheresOut,60\nspheresEnd,30\n"]);
%! assert (readContainer (folder), {NaN, NaN});

% SPDX-License-Identifier: GPL-3.0-only
