% MAKEDRUM  Writes the drum's mantle, with small ridges, as an STL file.
%
% CALL: makeDrum (FILE, RADIUS, WIDTH, NRIDGES, HEIGHT)
%
% FILE     text, name of the STL file, for instance drum.stl
% RADIUS   of the mantle (m)
% WIDTH    along y, from 0 (m)
% NRIDGES  number of ridges, so that the bed does not slide
% HEIGHT   of a ridge (m), above a base of twice the height
%
% drum.stl comes from makeDrum ('drum.stl', 0.04, 0.012, 30, 0.0015).
%
% See also: writeStl
function makeDrum (file, radius, width, nRidges, height)
  pitch = 2 * pi / nRidges;
  foot = 2 * height / radius;
  angle = (0:nRidges - 1) * pitch + [0; 0.5; 1] * foot;
  r = radius - height * [0; 1; 0] * ones (1, nRidges);
  angle = [angle(:); 2 * pi];
  r = [r(:); radius];
  x = r .* cos (angle);
  z = r .* sin (angle);
  n = numel (x) - 1;
  triangles = zeros (3, 3, 2 * n);
  y = [0; width; 0];
  for k = 1:n
    a = [x(k); 0; z(k)];
    b = [x(k + 1); 0; z(k + 1)];
    triangles(:, :, 2 * k - 1) = [a, b, b + y];
    triangles(:, :, 2 * k) = [a, b + y, a + y];
  end
  writeStl (file, triangles);
end
