% READRECORD  Reads a job or a run record.
%
% CALL: RECORD = readRecord (FILE)
%
% What it says need not be sane where others can write to the store: see
% isRunRecord.
%
%   FILE    path (text)
%   RECORD  scalar struct as it was written; [] where there is no file, or
%           where it is truncated or altered (its checksum is wrong)

function record = readRecord (file)
  record = [];
  fid = fopen (file, 'r');
  if fid < 0
    return
  end
  text = asUtf8 (fread (fid, [1, Inf], 'uint8=>char'));
  fclose (fid);
  parts = regexp (text, '^\{"sha256":"(\w{64})","record":(\{.*\})\}\n$', ...
                  'tokens', 'once');
  if isempty (parts) || ~strcmp (hash ('sha256', parts{2}), parts{1})
    return
  end
  record = asNumbers (jsondecode (parts{2}));
  if isstruct (record) && isstruct (givenField (record, 'readings', []))
    record.readings = arrayfun (@asNumbers, record.readings);
  end
end

function record = asNumbers (record)
  numbers = {'planRow', 'params', 'effects', 'replicate', 'seed', ...
             'results', 'seconds'};
  for k = find (isfield (record, numbers))
    if ischar (record.(numbers{k}))
      record.(numbers{k}) = sscanf (record.(numbers{k}), '%f')';
    end
  end
end

%!test
%! file = tempname ();
%! assert (isempty (readRecord (file)));
%! writeRecord (file, struct ('status', 'ok', 'results', [1, 2]));
%! assert (readRecord (file).results, [1, 2]);
%! text = fileread (file);
%! for broken = {text(1:end-3), strrep(text, '1 2', '1 3'), '', 'rubbish'}
%!   writeAtomic (file, broken{1});
%!   assert (isempty (readRecord (file)));
%! end

% SPDX-License-Identifier: GPL-3.0-only
