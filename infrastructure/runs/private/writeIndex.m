% WRITEINDEX  Writes the index of the runs of a model, see readIndex.
%
% CALL: writeIndex (FILE, KINDS, MARKS)
%
% Only its user can write to it. It is no fault where a store can be read alone:
% the next start reads the records.

function writeIndex (file, kinds, marks)
  numbers = cellfun (@(M) double (M)(:)', [{marks}, {kinds.runs}], ...
                     'UniformOutput', false);
  sizes = cellfun (@size, {kinds.runs}, 'UniformOutput', false);
  sizes = vertcat (zeros (0, 2), sizes{:});
  kinds = rmfield (kinds, 'runs');
  for k = 1:numel (kinds)
    kinds(k).rows = sizes(k, 1);
    kinds(k).columns = sizes(k, 2);
  end
  head = struct ('form', 1, 'marks', rows (marks), 'kinds', []);
  if ~isempty (kinds)                   % of none jsonencode makes half a line
    head.kinds = kinds;
  end
  mask = umask (77);
  back = onCleanup (@() umask (mask));
  try
    text = [jsonencode(head), "\n", char(typecast ([numbers{:}], 'uint8'))];
    writeAtomic (file, [hash('sha256', text), "\n", text], false);
  catch
    % a store that can be read alone, a full disk
  end
end

%!test
%! % where it cannot be written
%! kinds = struct ('input', {}, 'funs', {}, 'origin', {}, 'owner', {}, ...
%!                 'names', {}, 'runs', {});
%! writeIndex ('/nowhere/x', kinds, zeros (0, 3));
%! assert (! isfile ('/nowhere/x'));

% SPDX-License-Identifier: GPL-3.0-only
