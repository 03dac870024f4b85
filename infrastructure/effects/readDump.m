% READDUMP  Reads the grains that a bench has dumped.
%
% CALL: FRAMES = readDump (FILE)
%
% FILE    text file written by "dump custom ... id x y z radius"
% FRAMES  1 x k cell, one a dumped step: n x 4, columns x y z radius (m)
%
% Throws DEcalioc:readDump:missingFile, DEcalioc:readDump:badValue (a frame
% that breaks off).
%
% See also: silhouette, readChecks
function frames = readDump (file)
  if exist (file, 'file') ~= 2
    error ('DEcalioc:readDump:missingFile', ...
           'readDump: FILE must exist, got %s. Did the run end early?', file);
  end
  text = fileread (file);
  mark = 'ITEM: ATOMS';
  starts = strfind (text, mark);
  stops = [strfind(text, 'ITEM: TIMESTEP')(2:end) - 1, numel(text)];
  frames = cell (1, numel (starts));
  for k = 1:numel (starts)
    block = text(starts(k):stops(k));
    [names, body] = strtok (block(numel (mark) + 1:end), "\n");
    width = numel (strsplit (strtrim (names), ' '));
    numbers = sscanf (body, '%f');
    if mod (numel (numbers), width) ~= 0
      error ('DEcalioc:readDump:badValue', ...
             ['readDump: FILE must hold whole rows, frame %d of %s ' ...
              'breaks off.'], k, file);
    end
    rows = reshape (numbers, width, []).';
    frames{k} = rows(:, 2:5);
  end
end

%!function file = sampleDump (rows)
%!  file = tempname ();
%!  fid = fopen (file, 'w');
%!  for k = 1:2
%!    fprintf (fid, 'ITEM: TIMESTEP\n%d\nITEM: NUMBER OF ATOMS\n2\n', k);
%!    fprintf (fid, 'ITEM: BOX BOUNDS ff pp ff\n0 1\n0 1\n0 1\n');
%!    fprintf (fid, 'ITEM: ATOMS id x y z radius\n%s', rows);
%!  end
%!  fclose (fid);
%!endfunction

%!test % two frames of two grains
%! file = sampleDump (sprintf ('7 1 2 3 0.5\n3 4 5 6 0.25\n'));
%! frames = readDump (file);
%! delete (file);
%! assert (numel (frames), 2);
%! assert (frames{2}, [1, 2, 3, 0.5; 4, 5, 6, 0.25]);

%!error id=DEcalioc:readDump:missingFile readDump ('no such file')

%!test % a frame that breaks off
%! file = sampleDump (sprintf ('7 1 2 3 0.5\n3 4 5\n'));
%! caught = '';
%! try
%!   readDump (file);
%! catch err
%!   caught = err.identifier;
%! end
%! delete (file);
%! assert (caught, 'DEcalioc:readDump:badValue');
