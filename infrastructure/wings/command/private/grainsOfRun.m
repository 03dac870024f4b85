% GRAINSOFRUN  Counts the grains of a LIGGGHTS run, and collects what it warned of.
%
% CALL: G = grainsOfRun (FOLDER)
%
%   FOLDER  run folder (text), with log.liggghts or stdout.txt
%   G       scalar struct, numbers NaN where the output does not say: asked (grains
%           that the script asks for: of insertions, and those it creates or reads),
%           made (most that were there at the end of a command run), left (at the end of
%           the last one); warnings
%           (1 x n cell of texts: LIGGGHTS's own about insertion, loss and contacts
%           that are looked for too late, each once), and of lastGrains: overlap, moving

function g = grainsOfRun (folder)
  text = '';
  for name = {'log.liggghts', 'stdout.txt'}
    file = fullfile (folder, name{1});
    if isempty (text) && isfile (file)
      text = checkReadText (file);
    end
  end
  g = struct ('asked', askedFor (text), 'made', NaN, 'left', NaN, 'warnings', {{}});
  ends = regexp (text, '^Loop time of .* with (\d+) atoms', 'tokens', 'lineanchors', ...
                 'dotexceptnewline');
  ends = str2double ([cell(1, 0), ends{:}]);
  if ~isempty (ends)
    [g.made, g.left] = deal (max (ends), ends(end));
  end
  lines = regexp (text, '^WARNING: ([^\n]*?)\s*(?:\([\w./]+:\d+\))?$', 'tokens', ...
                  'lineanchors', 'dotexceptnewline');
  lines = unique ([cell(1, 0), lines{:}], 'stable');
  isOurs = ~cellfun (@isempty, regexpi (lines, 'insert|lost|dangerous|overlap', 'once'));
  g.warnings = lines(isOurs)(:)';
  [g.overlap, g.moving] = lastGrains (folder, text);
end

% The log has each command twice, the second time with its variables filled in. A
% region that is kept full all the time asks for no number.
function n = askedFor (text)
  lines = regexp (text, '^fix\s+(\S+)\s+\S+\s+insert/(\w+)([^\n]*)$', 'tokens', ...
                  'lineanchors', 'dotexceptnewline');
  numbers = struct ();
  for line = lines
    [id, kind, rest] = line{1}{:};
    form = '\<nparticles\s+(\d+)';
    if strcmp (kind, 'pack')
      form = '\<particles_in_region\s+(\d+)';
      if isempty (regexp (rest, '\<insert_every\s+once\>', 'once'))
        rest = '';
      end
    end
    found = regexp (rest, form, 'tokens', 'once');
    numbers.(['x', regexprep(id, '\W', '_')]) = str2double ([found, {'NaN'}]{1});
  end
  if isempty (lines)
    n = NaN;
    return
  end
  % create_atoms; read_data and read_restart
  others = regexp (text, '^(?:Created (\d+) atoms|\s+(\d+) atoms)$', 'tokens', 'lineanchors');
  n = sum ([struct2cell(numbers){:}, str2double([cell(1, 0), others{:}])]);
end

%!function g = of (text)
%!  [folder, put] = emptyFolder ();
%!  put ('log.liggghts', text);
%!  g = grainsOfRun (folder);
%!endfunction
%!test
%! pack = ["fix a all insert/pack seed ${s} insert_every once particles_in_region ${n}\n", ...
%!         "fix a all insert/pack seed 7 insert_every once particles_in_region 900\n"];
%! less = ["WARNING: Particle insertion: Less insertions than requested ", ...
%!         "(fix_insert.cpp:814)\n"];
%! g = of ([pack, "fix b all insert/stream nparticles 100 x\n", ...
%!          less, less, ...
%!          "WARNING: Something else (x.cpp:1)\n", ...
%!          "Loop time of 0.04 on 1 procs for 1 steps with 242 atoms, finish time Sun\n", ...
%!          "Loop time of 2 on 1 procs for 9 steps with 240 atoms, finish time Sun\n"]);
%! assert ([g.asked, g.made, g.left], [1000, 242, 240]);
%! assert (g.warnings, {'Particle insertion: Less insertions than requested'});
%! % grains of a glued floor, or of a data file, are asked for, too
%! before = "Created 185 atoms\n185 atoms in group glued\n  15 atoms\n";
%! assert (of ([before, pack]).asked, 1100);
%! assert (isnan (of ([pack, "fix c all insert/pack particles_in_region 5\n"]).asked));
%!test
%! g = grainsOfRun (emptyFolder ());
%! assert ({g.asked, g.made, g.left, g.warnings}, {NaN, NaN, NaN, cell(1, 0)});

% SPDX-License-Identifier: GPL-3.0-only
