% WRITERECORD  Writes a job or a run record as JSON with a checksum.
%
% CALL: writeRecord (FILE, RECORD)
%
%   FILE    path (text)
%   RECORD  scalar struct of texts and numeric row vectors; its field readings,
%           if it has one, a struct array of such
%
% {"sha256": checksum of what follows, "record": {...}}. Numbers are written
% as text with 17 significant digits, separated by spaces, because neither
% jsonencode nor jsondecode keeps the last digits. The disk is not waited for: a
% record that a power cut tears fails its checksum, and is made again of the
% run's files, which are on the disk (guard.sh).

function writeRecord (file, record)
  if isfield (record, 'readings')
    record.readings = arrayfun (@asTexts, record.readings);
  end
  record = asTexts (record);
  body = jsonencode (record);
  text = sprintf ('{"sha256":"%s","record":%s}\n', hash ('sha256', body), body);
  writeAtomic (file, text, false);
end

function record = asTexts (record)
  for name = fieldnames (record)'
    if ischar (record.(name{1}))
      record.(name{1}) = asUtf8 (record.(name{1}));
    elseif isnumeric (record.(name{1}))
      record.(name{1}) = strtrim (sprintf ('%.17g ', record.(name{1})));
    end
  end
end

%!test
%! file = tempname ();
%! r = struct ('model', "a\"b\n", 'params', [0.1, NaN, 1e-300], 'seconds', []);
%! writeRecord (file, r);
%! back = readRecord (file);
%! assert ({back.model, back.params}, {r.model, r.params});
%! assert (isempty (back.seconds));
%! r.readings = struct ('funs', {'f', 'g'}, 'results', {[1/3, 2], 5});
%! for n = [2, 1]
%!   r.readings = r.readings(1:n);
%!   writeRecord (file, r);
%!   back = readRecord (file);
%!   assert ({back.readings.results}, {r.readings.results});
%! end
%!test
%! % an error of getResults, whose file is in Windows-1252
%! file = tempname ();
%! writeRecord (file, struct ('message', ['H', char(246), 'he']));
%! assert (readRecord (file).message, ['H', char([195, 182]), 'he']);

% SPDX-License-Identifier: GPL-3.0-only
