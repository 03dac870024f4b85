% BENCHFOLDER  Makes the model folder of a bench that is set up in another way.
%
% CALL: FOLDER = benchFolder (CASE, BENCH)
%
%   CASE    see newCase
%   BENCH   scalar struct: name (of the model), source (folder of the bench),
%           origin (number of its model in CASE, 0: none), variable, unit, value
%           and old (what is changed; value []: nothing), change (struct of
%           values for data.head)
%   FOLDER  gap/next/DEMmodels/NAME of the case, made where it is not there; the
%           source itself where nothing is changed
%
% Results get names (results.csv), which measured.csv needs; places along a
% series, and words, that say the old value say the new one. A folder is copied
% under a name of its own first: a half-made one must not count.

function folder = benchFolder (Case, bench)
  folder = bench.source;
  if numfields (bench.change) == 0
    return
  end
  place = fullfile (Case.folder, 'gap', 'next', 'DEMmodels');
  folder = fullfile (place, bench.name);
  if isfolder (folder)
    return
  end
  [~, ~] = mkdir (place);
  % made aside and renamed: a copy that was broken off is never taken for the model
  half = tempname (place);
  mkdir (half);
  copyModel (half, bench.source);
  confirm_recursive_rmdir (false, 'local');
  if isfolder (fullfile (half, 'sample'))
    rmdir (fullfile (half, 'sample'), 's');
  end
  head = fullfile (half, 'data.head');
  writeAtomic (head, [fileread(head), "\n", headLines(bench.change)]);
  writeResults (half, Case, bench);
  rename (half, folder);
end

% Results by name: measured.csv needs it. Places along a series, and words, that
% say the value of the variable follow it.
function writeResults (folder, Case, bench)
  file = fullfile (folder, 'results.csv');
  info = resultInfo (folder);
  if isempty (info) && bench.origin > 0
    ofBench = Case.targets([Case.targets.model] == bench.origin);
    info = struct ('name', {ofBench.name}, 'kind', '', 'unit', '', ...
                   'series', '', 'at', NaN, 'text', '');
  end
  lines = {'name,kind,unit,series,at,text'};
  for r = info
    if isequal (r.at, bench.old)
      r.at = bench.value;
    end
    if ~isempty (bench.value)
      r.text = strrep (r.text, quantity (bench.old, bench.unit), ...
                       quantity (bench.value, bench.unit));
    end
    lines{end + 1} = csvLine ({r.name, r.kind, r.unit, r.series, r.at, r.text});
  end
  writeAtomic (file, [strjoin(lines, "\n"), "\n"]);
end

%!test
%! % words with a comma stay one column
%! root = fileparts (fileparts (which ('startToolbox')));
%! Case.folder = tempname ();
%! bench = struct ('name', 'Doser_grains', 'source', ...
%!                 fullfile (root, 'DEMmodels', 'Doser'), 'origin', 0, ...
%!                 'variable', '', 'unit', '', 'value', [], 'old', [], ...
%!                 'change', struct ('radiusP', 0.003));
%! info = resultInfo (benchFolder (Case, bench));
%! assert (info, resultInfo (bench.source));
%!test
%! root = fileparts (fileparts (which ('startToolbox')));
%! Case.folder = tempname ();
%! bench = struct ('name', 'SlotBin_slot2_45mm', 'source', ...
%!                 fullfile (root, 'DEMmodels', 'SlotBin'), 'origin', 1, ...
%!                 'variable', 'slot2', 'unit', 'm', 'value', 0.045, ...
%!                 'old', 0.03, 'change', struct ('slot2', 0.045));
%! folder = benchFolder (Case, bench);
%! assert (headDefaults (fullfile (folder, 'data.head')).slot2, 0.045);
%! info = resultInfo (folder);
%! assert ([info(3:4).at], [0.02, 0.045]);
%! assert (info(4).text, 'discharge through the slot of 45 mm');
%! assert (! isfolder (fullfile (folder, 'sample')));
%! assert (isfile (fullfile (folder, 'effects', 'material.inc')));
%! assert (benchFolder (Case, bench), folder);
%! % nothing changed: the bench itself
%! [bench.change, bench.value, bench.old] = deal (struct (), [], []);
%! assert (benchFolder (Case, bench), bench.source);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (Case.folder, 's');

% SPDX-License-Identifier: GPL-3.0-only
