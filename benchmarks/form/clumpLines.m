% CLUMPLINES  Makes grains of three or four spheres in a copy of a bench.
%
% CALL: LINES = clumpLines (N, ASPECT)
%
%   N       3: spheres in a row, length / width = ASPECT; 4: a tetrahedron whose
%           edge is 2 (ASPECT - 1) radii of a member
%   ASPECT  number above 1, below 2
%   LINES   cell of shell commands that write effects/clumps.inc
%
% Volume and density of the sphere that a grain stands for are kept. In a row
% the outer two overlap inside the middle one only, so that the volume is three
% spheres less two lenses; that of the tetrahedron is counted on a lattice.
%
% See also: swapForms

function lines = clumpLines (n, aspect)
  if n == 3
    step = aspect - 1;
    centre = [-step, 0, 0; 0, 0, 0; step, 0, 0];
    volume = 3 - 2 * lens (step);
  else
    centre = [1, 1, 1; 1, -1, -1; -1, 1, -1; -1, -1, 1] / sqrt (8) * ...
         2 * (aspect - 1);
    volume = countedVolume (centre);
  end
  scale = volume^(-1 / 3);                  % radius of a member / of the sphere
  text = {sprintf('variable rC equal %.8g*\\${radiusG}', scale)};
  spheres = '';
  for i = 1:n
    for j = 1:3
      text{end + 1} = sprintf ('variable c%d%d equal %.8g*\\${radiusG}', ...
                               i, j, scale * centre(i, j));
    end
    spheres = sprintf ('%s \\${c%d1} \\${c%d2} \\${c%d3} \\${rC}', spheres, ...
                       i, i, i);
  end
  text{end + 1} = sprintf (['fix tM all particletemplate/multisphere ' ...
                            '15485867 atom_type 1 density constant ' ...
                            '\\${densityG} nspheres %d ntry 1000000 ' ...
                            'spheres%s type 1'], n, spheres);
  text{end + 1} = ['fix grains all particledistribution/discrete/' ...
                   'numberbased 49979687 1 tM 1.0'];
  text{end + 1} = ['variable integrator string \"multisphere ' ...
                   'allow_group_and_set yes\"'];
  text = [text, {'variable integratorGroup string all', ...
                 sprintf('variable members equal %d', n)}];
  lines = {sprintf('printf "%%s\\n" %s > effects/clumps.inc', ...
                   sprintf ('"%s" ', text{:}))};
end

% Share of its volume that a unit sphere has in common with one this far away.
function share = lens (distance)
  share = (4 + distance) * (2 - distance)^2 / 16;
end

% In volumes of a member, of radius 1.
function volume = countedVolume (centre)
  reach = 1 + max (abs (centre(:)));
  n = 120;
  line = ((1:n) - 0.5) / n * 2 * reach - reach;
  [x, y, z] = ndgrid (line, line, line);
  inside = false (size (x));
  for i = 1:rows (centre)
    inside = inside | (x - centre(i, 1)).^2 + (y - centre(i, 2)).^2 + ...
                      (z - centre(i, 3)).^2 < 1;
  end
  volume = mean (inside(:)) * (2 * reach)^3 / (4 / 3 * pi);
end

%!test % two spheres that touch, and that lie in one another
%! text = clumpLines (3, 1 + 1e-9){1};
%! assert (~isempty (strfind (text, 'equal 1*')));
%!test % a tetrahedron of spheres that just overlap: between one and four
%! text = clumpLines (4, 1.4){1};
%! scale = str2double (regexp (text, 'rC equal ([\d.]+)', 'tokens', 'once'){1});
%! assert (scale < 1 && scale > 4^(-1 / 3));

% SPDX-License-Identifier: GPL-3.0-only
