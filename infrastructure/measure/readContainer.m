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
  counts = countsOf (fullfile (folder, 'output_checks.csv'));
  res = {readScalar(fullfile (folder, 'output_density')), ...
         readScalar(fullfile (folder, 'output_mass'))};
  if ~(counts.spheresKept <= 0.98 * counts.spheresFilled)
    res{1} = NaN;
  end
  if ~(counts.spheresOut + counts.spheresEnd == counts.spheresKept)
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
function counts = countsOf (file)
  counts = struct ('spheresFilled', NaN, 'spheresKept', NaN, ...
                   'spheresOut', NaN, 'spheresEnd', NaN);
  if exist (file, 'file') ~= 2
    return
  end
  found = regexp (fileread (file), '^(\w+),(\S+)$', 'tokens', ...
                  'lineanchors');
  for k = 1:numel (found)
    counts.(found{k}{1}) = str2double (found{k}{2});
  end
end

%!test
%! folder = tempname ();
%! mkdir (folder);
%! put = @(name, text) writeAtomic (fullfile (folder, name), text);
%! none = readContainer (folder);
%! put ('output_density', "400\n");
%! put ('output_mass', "0.025\n");
%! put ('output_checks.csv', ["spheresFilled,100\nspheresKept,90\n", ...
%!                            "spheresOut,60\nspheresEnd,30\n"]);
%! whole = readContainer (folder);
%! put ('output_checks.csv', ["spheresFilled,100\nspheresKept,99\n", ...
%!                            "spheresOut,60\nspheresEnd,30\n"]);
%! broken = readContainer (folder);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
%! assert (none, {NaN, NaN});
%! assert (whole, {400, 0.025});
%! assert (broken, {NaN, NaN});
