% READSUBMISSIONS  Reads which runs of a store were submitted to a queue.
%
% CALL: BATCHES = readSubmissions (PLACE)
%
%   PLACE    folder of the executor beside those of the runs, optim/.NAME (text)
%   BATCHES  1 x b struct array, one element a job array:
%     name     job name of the array, unique (text)
%     path     its folder, PLACE/<name> (text)
%     keys     n x 1 cell, keys of the runs; task k is the k-th
%     folders  n x 1 cell, run folders
%
% The ledger is written before anything is sent, so no job can be in the queue
% of which it does not know.

function batches = readSubmissions (place)
  batches = struct ('name', {}, 'path', {}, 'keys', {}, 'folders', {});
  for name = readdir (place)'
    folder = fullfile (place, name{1});
    file = fullfile (folder, 'tasks');
    if name{1}(1) == '.' || ~isfile (file)
      continue
    end
    % not regexp: the bytes of a path need be no UTF-8
    [keys, folders] = strtok (ostrsplit (fileread (file), "\n")', "\t");
    isWhole = cellfun (@numel, folders) > 1 & ~cellfun (@isempty, keys);
    folders = cellfun (@(f) f(2:end), folders(isWhole), ...
                       'UniformOutput', false);
    batches(end + 1) = struct ('name', name{1}, 'path', folder, ...
                               'keys', {keys(isWhole)}, 'folders', {folders});
  end
end

%!test
%! place = fullfile (tempname (), 'optim', '.q');
%! mkdir (fullfile (place, 'decalioc-1'));
%! mkdir (fullfile (place, 'decalioc-2'));
%! writeAtomic (fullfile (place, 'decalioc-1', 'tasks'), ...
%!              "k1\t/a b/it's\nk2\t/c\n");
%! b = readSubmissions (place);
%! assert (numel (b), 1);
%! assert ({b.keys, b.folders}, {{'k1'; 'k2'}, {'/a b/it''s'; '/c'}});
%! assert (isempty (readSubmissions (tempname ())));

% SPDX-License-Identifier: GPL-3.0-only
