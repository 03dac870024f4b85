% MAKEBIN  Write the bin of the model SmallBin as an ASCII STL file.
%
% CALL: makeBin (stlFile)
%
%   stlFile   text: the file to write
%
% Floor (z = 0), back wall (x = 0) and two side walls of a bin that is 60 mm
% long (x), 60 mm wide (y) and 120 mm high; front and top are open. Two
% triangles a face, corners in m.
%
% See also: in.SmallBin, getResults

function makeBin (stlFile)

  long = 0.06;
  wide = 0.06;
  high = 0.12;
  floor4 = [0, 0, 0; long, 0, 0; long, wide, 0; 0, wide, 0];
  back4 = [0, 0, 0; 0, wide, 0; 0, wide, high; 0, 0, high];
  right4 = [0, 0, 0; 0, 0, high; long, 0, high; long, 0, 0];
  left4 = right4([1, 4, 3, 2], :) + [0, wide, 0];

  [fid, message] = fopen (stlFile, 'w');
  if fid < 0
    error ('DEcalioc:makeBin:missingFile', ...
           'makeBin: %s must be writable, got: %s.', stlFile, message);
  end
  closeFile = onCleanup (@() fclose (fid));
  fprintf (fid, 'solid bin\n');
  faces = {floor4, back4, right4, left4};
  for k = 1:numel (faces)
    writeTriangle (fid, faces{k}([1, 2, 3], :));
    writeTriangle (fid, faces{k}([1, 3, 4], :));
  end
  fprintf (fid, 'endsolid bin\n');

end

% One facet; corners 3 x 3, a corner a row, anticlockwise seen from inside.
function writeTriangle (fid, corners)

  normal = cross (corners(2, :) - corners(1, :), ...
                  corners(3, :) - corners(1, :));
  % + 0 turns a negative zero into a zero
  normal = normal / norm (normal) + 0;
  fprintf (fid, ' facet normal %.6f %.6f %.6f\n  outer loop\n', normal);
  fprintf (fid, '   vertex %.6f %.6f %.6f\n', corners');
  fprintf (fid, '  endloop\n endfacet\n');

end
