% MAKEDOSER  Writes the meshes of a tube with a screw as STL and VTK files.
%
% CALL: makeDoser (FOLDER, SIZES)
%
% FOLDER  text, receives tube.stl (bore and cone), screw.stl (flight, core and
%         tip), plug.stl (a plate), gap.inc (regions where grains are put in)
% SIZES   scalar struct (m): bore and core (radii), pitch, long (of the screw),
%         exit (radius), halfAngle (of the cone, degree)
%
% The axis is x; the screw is right-handed from x = 0, one flight without a
% thickness, and turns about -x. The cone follows at x = long, the tip of the core
% reaches its end. gap.inc has cylinders between the flights.
%
% The files come from makeDoser ('.', struct ('bore', 0.026125, 'core', 0.01,
% 'pitch', 0.026, 'long', 0.052, 'exit', 0.013, 'halfAngle', 37)).
%
% See also: writeStl
function makeDoser (folder, sizes)
  s = sizes;
  coneEnd = s.long + (s.bore - s.exit) / tand (s.halfAngle);
  angles = linspace (0, 2 * pi, 37);
  tube = surfaceOf ([0, s.long, coneEnd], [s.bore, s.bore, s.exit], angles);
  writeStl (fullfile (folder, 'tube.stl'), tube);
  core = surfaceOf ([0, s.long, coneEnd], [s.core, s.core, s.core / 5], ...
                    linspace (0, 2 * pi, 19));
  angle = 0:pi / 12:2 * pi * s.long / s.pitch;
  x = s.pitch * angle / (2 * pi);
  flight = patchOf (pointsAt (x, s.core, angle), pointsAt (x, s.bore, angle));
  writeStl (fullfile (folder, 'screw.stl'), cat (3, core, flight));
  wide = 1.1 * s.exit * [-1, 1];
  plug = patchOf ([coneEnd, coneEnd; wide; -2.2 * s.exit, -2.2 * s.exit], ...
                  [coneEnd, coneEnd; wide; 0, 0]);
  writeStl (fullfile (folder, 'plug.stl'), plug);
  writeGap (fullfile (folder, 'gap.inc'), s);
end

function points = pointsAt (x, r, angle)
  points = [x; r .* cos(angle); r .* sin(angle)];
end

% a strip of triangles between two lines of points (3 x n)
function triangles = patchOf (low, high)
  n = columns (low) - 1;
  triangles = zeros (3, 3, 2 * n);
  for k = 1:n
    triangles(:, :, 2 * k - 1) = [low(:, k), low(:, k + 1), high(:, k + 1)];
    triangles(:, :, 2 * k) = [low(:, k), high(:, k + 1), high(:, k)];
  end
end

% rings of the radii r at x; a long one in pieces about as long as wide
function triangles = surfaceOf (x, r, angle)
  triangles = zeros (3, 3, 0);
  one = ones (size (angle));
  for k = 1:numel (x) - 1
    a = pointsAt (x(k) * one, r(k), angle);
    b = pointsAt (x(k + 1) * one, r(k + 1), angle);
    a(:, end) = a(:, 1);
    b(:, end) = b(:, 1);
    triangles = cat (3, triangles, patchOf (a, b));
  end
end

% cylinders along x from one flight to the next, an eighth of a turn apart
function writeGap (file, s)
  angle = 0:pi / 4:2 * pi * (s.long / s.pitch - 1);
  middle = (s.bore + s.core) / 2;
  r = (s.bore - s.core) / 2;
  side = s.pitch * asin (r / middle) / (2 * pi);
  x = s.pitch * angle / (2 * pi) + side;
  rows_ = [1:numel(x); middle * cos(angle); middle * sin(angle); ...
           r * ones(1, numel (x)); x; x + s.pitch - 2 * side];
  text = sprintf ("region gap%d cylinder x %.6g %.6g %.6g %.6g %.6g units box\n", ...
                  rows_);
  names = @(n) [sprintf('%d', n), sprintf(' gap%d', 1:n)];
  writeAtomic (file, ["# made by makeDoser: where no grain touches the screw\n", ...
                      text, 'region gap union ', names(numel (x)), "\n"]);
end
