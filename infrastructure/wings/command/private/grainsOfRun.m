% GRAINSOFRUN  Counts the grains of a LIGGGHTS run, and collects what it warned of.
%
% CALL: G = grainsOfRun (FOLDER)
%
%   FOLDER  run folder (text), with log.liggghts or stdout.txt
%   G       scalar struct, numbers NaN where the output does not say: asked (grains
%           that the script asks for: of insertions, and those it creates or reads),
%           made (most that were there at the end of a command run), left (at the end of
%           the last one), glued (0 where nothing tells: those that stand on a lattice,
%           of a rough floor or lid, which the three others leave out); warnings
%           (1 x n cell of texts: LIGGGHTS's own about insertion, loss and contacts
%           that are looked for too late, each once); overlap, moving (lastGrains)

function g = grainsOfRun (folder)
  % a script may send its log elsewhere: the one that tells of a run to its end
  text = '';
  for name = {'log.liggghts', 'stdout.txt'}
    file = fullfile (folder, name{1});
    isWhole = ~isempty (regexp (text, '^Loop time of ', 'once', 'lineanchors'));
    if ~isWhole && isfile (file) && ~isempty (checkReadText (file))
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
  if g.made == 0                         % in one command run all came and went
    g.made = insertedIn (text);
  end
  g = withoutGlued (g, folder, text);
  lines = regexp (text, '^WARNING: ([^\n]*?)\s*(?:\([\w./]+:\d+\))?$', 'tokens', ...
                  'lineanchors', 'dotexceptnewline');
  lines = unique ([cell(1, 0), lines{:}], 'stable');
  isOurs = ~cellfun (@isempty, regexpi (lines, 'insert|lost|dangerous|overlap', 'once'));
  g.warnings = lines(isOurs)(:)';
  [g.overlap, g.moving] = lastGrains (folder, text);
end

% What its insertions say at last.
function n = insertedIn (text)
  said = regexp (text, ['Particle insertion (\S+):[^\n]*\n[^\n]*a total of (\d+) ' ...
                        'particle'], 'tokens');
  totals = struct ();
  for one = said
    totals.(['x', regexprep(one{1}{1}, '\W', '_')]) = str2double (one{1}{2});
  end
  n = sum ([struct2cell(totals){:}, 0]);
end

% A rig says in output_checks.csv how many grains were filled in; others that its log
% names as created are glued to it.
function g = withoutGlued (g, folder, text)
  g.glued = 0;
  file = fullfile (folder, 'output_checks.csv');
  created = regexp (text, '^Created (\d+) atoms$', 'tokens', 'lineanchors');
  if isempty (created) || ~isfile (file)
    return
  end
  filled = regexp (readText (file), '^spheresStart,(\d+)', 'tokens', 'once', 'lineanchors');
  most = sum (str2double ([created{:}]));
  g.glued = max ([0, min(g.made - str2double (filled), most)]);
  for name = {'asked', 'made', 'left'}
    g.(name{1}) = g.(name{1}) - g.glued;
  end
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

% How deep the grains overlap at the end, in diameters of the smaller one of a pair, and the
% share that is faster than after a fall of its radius. Of the last frame of the last "dump
% custom" with x, y, z and radius. NaN where nothing of the kind was dumped, of clumps and
% bonded grains (their spheres overlap by intent), and of more than 20,000 grains or 50 MB,
% which take too long.
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
%! % a log that the script sends elsewhere; all lost in one command run
%! [folder, put] = emptyFolder ();
%! put ('log.liggghts', "fix a all insert/pack insert_every once particles_in_region 9\nlog b\n");
%! put ('stdout.txt', ["INFO: Particle insertion a: inserted 7 particle templates (mass 1) ", ...
%!                     "at step 1\n - a total of 7 particle templates (mass 1) inserted so ", ...
%!                     "far.\nLoop time of 2 on 1 procs for 9 steps with 0 atoms, f\n"]);
%! g = grainsOfRun (folder);
%! assert ([g.made, g.left], [7, 0]);
%!test
%! % 69 glued to the plate, 151 of 298 fell off it; a lid that is made later
%! log = @(more) ["fix a all insert/pack insert_every once particles_in_region 298\n", ...
%!                "Created 69 atoms\n", more, ...
%!                "Loop time of 2 on 1 procs for 9 steps with 367 atoms, f\n", ...
%!                "Loop time of 2 on 1 procs for 9 steps with 216 atoms, f\n"];
%! [folder, put] = emptyFolder ();
%! put ('log.liggghts', log (''));
%! g = grainsOfRun (folder);
%! assert ([g.asked, g.made, g.left, g.glued], [367, 367, 216, 0]);
%! put ('output_checks.csv', "spheresStart,298\nspheresEnd,147\n");
%! g = grainsOfRun (folder);
%! assert ([g.asked, g.made, g.left, g.glued], [298, 298, 147, 69]);
%! put ('log.liggghts', log ("Created 5 atoms\n"));
%! put ('output_checks.csv', "spheresStart,293\n");
%! assert (grainsOfRun (folder).glued, 74);
%! put ('output_checks.csv', "other,1\n");
%! assert (grainsOfRun (folder).glued, 0);
%!test
%! g = grainsOfRun (emptyFolder ());
%! assert ({g.asked, g.made, g.left, g.warnings}, {NaN, NaN, NaN, cell(1, 0)});
%!test
%! % two frames; three grains of which two overlap by a tenth, and one still falls
%! [folder, put] = emptyFolder ();
%! head = @(step) sprintf (["ITEM: TIMESTEP\n%d\nITEM: NUMBER OF ATOMS\n3\n", ...
%!                          "ITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\n", ...
%!                          "ITEM: ATOMS id x y z vx vy vz radius\n"], step);
%! put ('a.dump', [head(0), "1 0 0 0 0 0 0 1\n2 9 0 0 0 0 0 1\n3 5 0 0 0 0 0 1\n", head(9), ...
%!                 "1 0 0 0 0 0 0 1\n3 5 0 0 0 0 -9 1\n2 1.8 0 0 0.1 0 0 1\n"]);
%! log = "dump d all custom 9 a.dump id x y z vx vy vz radius\n";
%! put ('log.liggghts', log);
%! g = grainsOfRun (folder);
%! assert ([g.overlap, g.moving], [0.1, 1/3], 1e-12);
%! for other = {[log, "fix c all multisphere\n"], strrep(log, ' radius', ''), ''}
%!   put ('log.liggghts', other{1});
%!   assert (isnan (grainsOfRun (folder).overlap));
%! end

% SPDX-License-Identifier: GPL-3.0-only
