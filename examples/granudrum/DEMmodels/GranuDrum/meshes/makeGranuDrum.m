% MAKEGRANUDRUM  Writes mantle and end windows of a drum as two STL files.
%
% CALL: makeGranuDrum (FOLDER, RADIUS, WIDTH, N)
%
% FOLDER  text, where mantle.stl and windows.stl go
% RADIUS  of the mantle (m);  WIDTH  along y, from 0 (m)
% N       number of facets of the mantle, a multiple of 3: a window has N / 3
%
% The windows reach 2 % beyond the mantle. The files of the bench come from
% makeGranuDrum ('.', 0.042, 0.02, 72).
%
% See also: writeStl
function makeGranuDrum (folder, radius, width, n)
  angle = 2 * pi * (0:n) / n;
  rim = [radius * cos(angle); zeros(1, n + 1); radius * sin(angle)];
  across = [0; width; 0];
  mantle = zeros (3, 3, 2 * n);
  for k = 1:n
    a = rim(:, k);
    b = rim(:, k + 1);
    mantle(:, :, 2 * k - 1) = [a, b, b + across];
    mantle(:, :, 2 * k) = [a, b + across, a + across];
  end
  writeStl (fullfile (folder, 'mantle.stl'), mantle);
  wide = 1.02 * rim(:, 1:3:end);
  windows = zeros (3, 3, 2 * n / 3);
  for k = 1:n / 3
    fan = [[0; 0; 0], wide(:, k), wide(:, k + 1)];
    windows(:, :, 2 * k - 1) = fan;
    windows(:, :, 2 * k) = fan + across;
  end
  writeStl (fullfile (folder, 'windows.stl'), windows);
end
