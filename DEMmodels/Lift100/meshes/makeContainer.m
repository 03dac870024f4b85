% MAKECONTAINER  Write the container of the model Lift100 as an ASCII STL file.
%
% CALL: makeContainer (stlFile)
%
%   stlFile   text: the file to write
%
% An open cylinder stands on a flat bottom at z = 0, with an orifice in the
% middle of the bottom: inner diameter 100 mm, wall height 60 mm, orifice
% 33 mm. Circles are polygons of 72 corners whose area is that of the circle:
% the corners lie on radius * sqrt (a / sin (a)) with a = 2 pi / 72, so that
% the volume of the filling is right to the last digit. Corners in m.
%
% See also: in.Lift100, getResults

function makeContainer (stlFile)

  nCorners = 72;
  angle = 2 * pi / nCorners;
  sameArea = sqrt (angle / sin (angle));
  wallRadius = 0.05 * sameArea;
  holeRadius = 0.0165 * sameArea;
  wallHeight = 0.06;

  bottom = ring (holeRadius, 0, wallRadius, 0, nCorners);
  wall = ring (wallRadius, 0, wallRadius, wallHeight, nCorners);
  writeStl (stlFile, [bottom; wall]);

end

% Triangles between two circles about the z axis, n x 9: three corners a row.
function triangles = ring (radius1, z1, radius2, z2, nCorners)

  t = 2 * pi * (0:nCorners)' / nCorners;
  t(end) = 0;
  first = [radius1 * cos(t), radius1 * sin(t), z1 * ones(size (t))];
  second = [radius2 * cos(t), radius2 * sin(t), z2 * ones(size (t))];
  a = 1:nCorners;
  b = a + 1;
  triangles = [first(a, :), second(a, :), second(b, :); ...
               first(a, :), second(b, :), first(b, :)];

end

function writeStl (stlFile, triangles)

  [fid, message] = fopen (stlFile, 'w');
  if fid < 0
    error ('DEcalioc:makeContainer:missingFile', ...
           'makeContainer: %s must be writable, got: %s.', stlFile, message);
  end
  closeFile = onCleanup (@() fclose (fid));
  fprintf (fid, 'solid container\n');
  for k = 1:rows (triangles)
    corners = reshape (triangles(k, :), 3, 3);
    normal = cross (corners(:, 2) - corners(:, 1), ...
                    corners(:, 3) - corners(:, 1));
    % + 0 turns a negative zero into a zero
    normal = round (1e6 * normal / norm (normal)) / 1e6 + 0;
    corners = round (1e9 * corners) / 1e9 + 0;
    fprintf (fid, ' facet normal %.6f %.6f %.6f\n  outer loop\n', normal);
    fprintf (fid, '   vertex %.9f %.9f %.9f\n', corners);
    fprintf (fid, '  endloop\n endfacet\n');
  end
  fprintf (fid, 'endsolid container\n');

end
