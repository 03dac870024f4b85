% READDUMP  Reads columns of a LIGGGHTS dump, by the names in its header.
%
% CALL: FRAMES = readDump (FILE)
%       [FRAMES, STEPS] = readDump (FILE, NAMES)
%
% FILE    text file written by "dump custom" or "dump local", or a vtk file of
%         particles as text (POINTS, and fields of POINT_DATA). A * in it stands
%         for the numbers of files of one frame each, 'post/dump*.liggghts':
%         read in the order of these numbers
% NAMES   1 x c cell of column names as the header has them, in any order:
%         {'x', 'y', 'z', 'vx'}; default {'x', 'y', 'z', 'radius'}, which
%         silhouette and the other reading functions take
% FRAMES  1 x k cell, one a dumped step: n x c, columns as NAMES
% STEPS   1 x k, number of the time step of each frame
%
% The header is the line "ITEM: ATOMS id type x y z ..." (of a local dump
% "ITEM: ENTRIES c_f[1] ..."). Where a name stands there twice, as "type" of
% LIGGGHTS does, its first column counts. Dumps of text (the element of a
% particle) are not read. Of a vtk file x, y, z are the points, other names
% fields of one number, or NAMEx, NAMEy, NAMEz of three (v: vx, vy, vz); STEPS are
% the last numbers in the names of its files.
%
% Throws DEcalioc:readDump:missingFile, DEcalioc:readDump:badValue (a frame
% that breaks off), DEcalioc:readDump:unknownName (no such column).
%
% See also: silhouette, surfaceAt, surfaceAngle, heightProfile, massInRegion
function [frames, steps] = readDump (file, names)
  if nargin < 2
    names = {'x', 'y', 'z', 'radius'};
  end
  files = {file};
  if any (file == '*')
    files = inOrder (file);
  end
  [frames, steps] = deal (cell (1, 0), zeros (1, 0));
  for name = files
    [some, at] = readOne (name{1}, names);
    frames = [frames, some];
    steps = [steps, at];
  end
end

% By the number in place of the *: dump2 comes before dump10.
function files = inOrder (pattern)
  files = glob (pattern)';
  parts = strsplit (pattern, '*');
  numbers = cellfun (@(f) str2double (f(numel (parts{1}) + 1: ...
                                        end - numel (parts{end}))), files);
  files = files(isfinite (numbers));
  [~, order] = sort (numbers(isfinite (numbers)));
  files = files(order);
  if isempty (files)
    refuseMissing (pattern);
  end
end

function refuseMissing (file)
  error ('DEcalioc:readDump:missingFile', ...
         'readDump: FILE must exist, got %s. Did the run end early?', file);
end

function [frames, steps] = readOne (file, names)
  if exist (file, 'file') ~= 2
    refuseMissing (file);
  end
  text = readText (file);
  if strncmp (text, '# vtk', 5)
    frames = {readVtk(text, names, file)};
    steps = str2double (regexp (file, '\d+(?=\D*$)', 'match', 'once'));
    return
  end
  [heads, starts] = regexp (text, ...
                            '^ITEM: (?:ATOMS|ENTRIES)[ \t]*([^\r\n]*)', ...
                            'tokens', 'end', 'lineanchors');
  begins = strfind (text, 'ITEM: TIMESTEP');
  stops = [begins(2:end) - 1, numel(text)];
  frames = cell (1, numel (starts));
  steps = NaN (1, numel (starts));
  for k = 1:numel (starts)
    places = columnsOf (names, heads{k}{1}, file);
    width = numel (strsplit (strtrim (heads{k}{1})));
    numbers = sscanf (text(starts(k) + 1:stops(k)), '%f');
    if mod (numel (numbers), width) ~= 0
      error ('DEcalioc:readDump:badValue', ...
             ['readDump: FILE must hold whole rows, frame %d of %s ' ...
              'breaks off.'], k, file);
    end
    table = reshape (numbers, width, []).';
    frames{k} = table(:, places);
    steps(k) = sscanf (text(begins(k) + 14:starts(k)), '%f', 1);
  end
end

function places = columnsOf (names, head, file)
  there = strsplit (strtrim (head));
  [~, first] = unique (there, 'first');
  [isThere, places] = ismember (names, there(first));
  if ~all (isThere)
    error ('DEcalioc:readDump:unknownName', ...
           ['readDump: NAMES must stand in the header of %s, got %s. The ' ...
            'header has: %s. Add the name to the dump command.'], ...
           file, names{find(~isThere, 1)}, strjoin (there, ' '));
  end
  places = first(places);
end

%!function file = sampleDump (names, rows)
%!  file = tempname ();
%!  form = ['ITEM: TIMESTEP\n%d\nITEM: NUMBER OF ATOMS\n2\n', ...
%!          'ITEM: BOX BOUNDS ff pp ff\n0 1\n0 1\n0 1\nITEM: %s\n%s'];
%!  text = [sprintf(form, 50, names, rows), sprintf(form, 100, names, rows)];
%!  writeAtomic (file, text);
%!endfunction

%!test % two frames of two grains
%! [frames, steps] = readDump (sampleDump ('ATOMS id x y z radius ', ...
%!                                         "7 1 2 3 0.5\n3 4 5 6 0.25\n"));
%! assert (numel (frames), 2);
%! assert (frames{2}, [1, 2, 3, 0.5; 4, 5, 6, 0.25]);
%! assert (steps, [50, 100]);

%!test % columns by their names, wherever they stand and however many there are
%! file = sampleDump ('ATOMS id type type radius vx x z y', ...
%!                    "7 1 2 0.5 9 1 3 2\n3 1 1 0.25 8 4 6 5\n");
%! assert (readDump (file){1}, [1, 2, 3, 0.5; 4, 5, 6, 0.25]);
%! assert (readDump (file, {'vx', 'type'}){2}, [9, 1; 8, 1]);

%!test % a dump of contacts; a step without any
%! file = sampleDump ('ENTRIES c_f[1] c_f[2]', '');
%! assert (size (readDump (file, {'c_f[2]'}){1}), [0, 1]);

%!test % one file a frame, in the order of their numbers
%! folder = emptyFolder ();
%! for step = [2, 10]
%!   text = strrep (fileread (sampleDump ('ATOMS id x y z radius ', ...
%!                                        sprintf ("7 %d 2 3 0.5\n", step))), ...
%!                  "E\n100\n", 'x');
%!   text = text(1:strfind (text, 'ITEM: TIMESTEP')(2) - 1);
%!   writeAtomic (fullfile (folder, sprintf ('d%d.txt', step)), text);
%! end
%! writeAtomic (fullfile (folder, 'dx.txt'), 'no frame');
%! frames = readDump (fullfile (folder, 'd*.txt'));
%! assert (cellfun (@(f) f(1), frames), [2, 10]);
%! vtk = ["# vtk DataFile Version 2.0\nx\nASCII\nDATASET POLYDATA\n", ...
%!        "POINTS 2 float\n1 2 3 4 5 6\nVERTICES 2 4\n1 0\n1 1\n", ...
%!        "POINT_DATA 2\nSCALARS radius float 1\nLOOKUP_TABLE default\n", ...
%!        "0.5 0.25\nVECTORS v float\n7 8 9\n10 11 12\n", ...
%!        "FIELD FieldData 1\nmass 1 2 double\n3 4\n"];
%! writeAtomic (fullfile (folder, 'v30.vtk'), vtk);
%! [frames, steps] = readDump (fullfile (folder, 'v*.vtk'), ...
%!                             {'x', 'z', 'radius', 'vy', 'mass'});
%! assert (frames{1}, [1, 3, 0.5, 8, 3; 4, 6, 0.25, 11, 4]);
%! assert (steps, 30);
%!error id=DEcalioc:readDump:missingFile readDump ('no such*file')
%!error id=DEcalioc:readDump:missingFile readDump ('no such file')
%!error id=DEcalioc:readDump:unknownName
%! readDump (sampleDump ('ATOMS id x', "7 1\n3 4\n"), {'x', 'fx'});
%!error id=DEcalioc:readDump:badValue      % a frame that breaks off
%! readDump (sampleDump ('ATOMS id x y z radius', "7 1 2 3 0.5\n3 4 5\n"));

% SPDX-License-Identifier: GPL-3.0-only
