% WRITESTL  Writes triangles as an ASCII STL file.
%
% CALL: writeStl (FILE, TRIANGLES)
%
% FILE       text, name of the file
% TRIANGLES  3 x 3 x n, coordinates (m) x corners x triangles
%
% Throws DEcalioc:writeStl:badShape, DEcalioc:writeAtomic:cannotWrite.
function writeStl (file, triangles)
  if size (triangles, 1) ~= 3 || size (triangles, 2) ~= 3
    error ('DEcalioc:writeStl:badShape', ...
           'writeStl: TRIANGLES must be 3 x 3 x n, got %d x %d x %d.', ...
           size (triangles, 1), size (triangles, 2), size (triangles, 3));
  end
  parts = cell (1, size (triangles, 3));
  for k = 1:numel (parts)
    corners = triangles(:, :, k);
    edges = corners(:, 2:3) - corners(:, 1);
    normal = cross (edges(:, 1), edges(:, 2));
    normal = normal / norm (normal);
    parts{k} = [sprintf("  facet normal %.9g %.9g %.9g\n", normal), ...
                "    outer loop\n", ...
                sprintf("      vertex %.9g %.9g %.9g\n", corners), ...
                "    endloop\n  endfacet\n"];
  end
  writeAtomic (file, ["solid bench\n", parts{:}, "endsolid bench\n"]);
end

%!test % one triangle in the plane z = 0 looks up
%! file = tempname ();
%! writeStl (file, [0, 1, 0; 0, 0, 1; 0, 0, 0]);
%! text = fileread (file);
%! assert (numel (strfind (text, 'vertex')), 3);
%! assert (~isempty (strfind (text, 'facet normal 0 0 1')));

%!error id=DEcalioc:writeStl:badShape writeStl ('x.stl', zeros (2, 3))
%!error id=DEcalioc:writeAtomic:cannotWrite ...
%! writeStl ('/no/such/folder/x.stl', zeros (3, 3, 0))

% SPDX-License-Identifier: GPL-3.0-only
