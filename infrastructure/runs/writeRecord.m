% WRITERECORD  Writes a job or a run record as JSON with a checksum.
%
% CALL: writeRecord (FILE, RECORD)
%
%   FILE    path (text)
%   RECORD  scalar struct of texts and numeric row vectors
%
% {"sha256": checksum of what follows, "record": {...}}. Numbers are written
% as text with 17 significant digits, separated by spaces, because neither
% jsonencode nor jsondecode keeps the last digits. The disk is not waited for: a
% record that a power cut tears fails its checksum, and is made again of the
% run's files, which are on the disk (guard.sh).

function writeRecord (file, record)
  names = fieldnames (record);
  for k = 1:numel (names)
    if ischar (record.(names{k}))
      record.(names{k}) = asUtf8 (record.(names{k}));
    else
      record.(names{k}) = strtrim (sprintf ('%.17g ', record.(names{k})));
    end
  end
  body = jsonencode (record);
  text = sprintf ('{"sha256":"%s","record":%s}\n', hash ('sha256', body), body);
  writeAtomic (file, text, false);
end

%!test
%! file = tempname ();
%! r = struct ('model', "a\"b\n", 'params', [0.1, NaN, 1e-300], 'seconds', []);
%! writeRecord (file, r);
%! back = readRecord (file);
%! assert ({back.model, back.params}, {r.model, r.params});
%! assert (isempty (back.seconds));
%!test
%! % an error of getResults, whose file is in Windows-1252
%! file = tempname ();
%! writeRecord (file, struct ('message', ['H', char(246), 'he']));
%! assert (readRecord (file).message, ['H', char([195, 182]), 'he']);
