% LASTGRAINS  How deep the grains of a run overlap at its end, and how many move.
%
% CALL: [OVERLAP, MOVING] = lastGrains (FOLDER, TEXT)
%
%   FOLDER   of a LIGGGHTS run;  TEXT  its log
%   OVERLAP  largest overlap of two grains, in diameters of the smaller one
%   MOVING   share of the grains that are faster than after a fall of their radius
%
% Of the last frame of the last "dump custom" with x, y, z and radius. NaN where
% nothing of the kind was dumped, of clumps and bonded grains (their spheres overlap
% by intent), and of more than 20,000 grains or 50 MB, which take too long.

function [overlap, moving] = lastGrains (folder, text)
  [overlap, moving] = deal (NaN);
  dumps = regexp (text, '^dump\s+\S+\s+\S+\s+custom\S*\s+\S+\s+(\S+)\s+([^\n]*)$', ...
                  'tokens', 'lineanchors', 'dotexceptnewline');
  isClump = ~isempty (regexp (text, '\<(multisphere|bond)\>', 'once'));
  for dump = dumps(end:-1:1)
    grains = grainsIn (fullfile (folder, dump{1}{1}), strsplit (strtrim (dump{1}{2})));
    if ~isempty (grains) && ~isClump
      overlap = overlapOf (sortrows (grains(:, 1:4)));
      speed2 = sum (grains(:, 5:end).^2, 2);
      moving = mean (speed2 > 2 * 9.81 * grains(:, 4));
      if columns (grains) < 7
        moving = NaN;
      end
      return
    end
  end
end

% The last frame: x, y, z, radius, and the speeds where they are known.
function grains = grainsIn (file, have)
  grains = [];
  place = {'x', 'y', 'z', 'radius'};
  files = glob (file);
  isLarge = sum (cellfun (@(f) stat (f).size, files)) > 50e6;
  if isempty (files) || isLarge || ~all (ismember (place, have))
    return
  end
  speed = {'vx', 'vy', 'vz'};
  try
    grains = readDump (file, [place, speed(ismember (speed, have))]){end};
  catch
    return                               % a frame that breaks off says nothing
  end
  grains = grains(1:end * (rows (grains) <= 20000), :);
end

% G by rows of x, y, z, radius, in the order of x: only near ones along x can touch.
function most = overlapOf (G)
  most = 0;
  for k = 1:rows (G) - 1
    [a, b] = deal (G(1:end - k, :), G(1 + k:end, :));
    if all (b(:, 1) - a(:, 1) > 2 * max (G(:, 4)))
      return
    end
    apart = sqrt (sum ((a(:, 1:3) - b(:, 1:3)).^2, 2));
    deep = (a(:, 4) + b(:, 4) - apart) ./ (2 * min (a(:, 4), b(:, 4)));
    most = max ([most; deep]);
  end
end

%!test
%! % two frames; three grains of which two overlap by a tenth, and one still falls
%! [folder, put] = emptyFolder ();
%! head = @(step) sprintf (["ITEM: TIMESTEP\n%d\nITEM: NUMBER OF ATOMS\n3\n", ...
%!                          "ITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\n", ...
%!                          "ITEM: ATOMS id x y z vx vy vz radius\n"], step);
%! put ('a.dump', [head(0), "1 0 0 0 0 0 0 1\n2 9 0 0 0 0 0 1\n3 5 0 0 0 0 0 1\n", head(9), ...
%!                 "1 0 0 0 0 0 0 1\n3 5 0 0 0 0 -9 1\n2 1.8 0 0 0.1 0 0 1\n"]);
%! log = "dump d all custom 9 a.dump id x y z vx vy vz radius\n";
%! [overlap, moving] = lastGrains (folder, log);
%! assert ([overlap, moving], [0.1, 1/3], 1e-12);
%! assert (isnan (lastGrains (folder, [log, "fix c all multisphere\n"])));
%! assert (isnan (lastGrains (folder, strrep (log, ' radius', ''))));
%! assert (isnan (lastGrains (folder, '')));

% SPDX-License-Identifier: GPL-3.0-only
