% MAKEHEAP  Writes the plate and the tube of the heap test as STL files.
%
% CALL: makeHeap (FOLDER, PLATERADIUS, TUBERADIUS, TUBEHEIGHT, NFACETS)
%
% FOLDER       text; disc.stl and tube.stl are written there
% PLATERADIUS  of the disc at z = 0 (m)
% TUBERADIUS   of the open tube above it (m)
% TUBEHEIGHT   its height (m)
% NFACETS      corners of both
%
% Made with makeHeap ('.', 0.032, 0.015, 0.1, 24).
%
% See also: writeStl
function makeHeap (folder, plateRadius, tubeRadius, tubeHeight, nFacets)
  angle = 2 * pi * (0:nFacets) / nFacets;
  ring = [cos(angle); sin(angle); zeros(1, nFacets + 1)];
  disc = zeros (3, 3, nFacets);
  tube = zeros (3, 3, 2 * nFacets);
  up = [0; 0; tubeHeight];
  for k = 1:nFacets
    disc(:, :, k) = plateRadius * [zeros(3, 1), ring(:, k:k + 1)];
    a = tubeRadius * ring(:, k);
    b = tubeRadius * ring(:, k + 1);
    tube(:, :, 2 * k - 1) = [a, b, b + up];
    tube(:, :, 2 * k) = [a, b + up, a + up];
  end
  writeStl (fullfile (folder, 'disc.stl'), disc);
  writeStl (fullfile (folder, 'tube.stl'), tube);
end
