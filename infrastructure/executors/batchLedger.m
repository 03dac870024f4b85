% BATCHLEDGER  Reads which runs of a store were submitted to a queue.
%
% CALL: BATCHES = batchLedger (STORE, NAME)
%
%   STORE    folder of the run store (text)
%   NAME     name of the executor (text)
%   BATCHES  1 x b struct array, one element a job array:
%     name     job name of the array, unique (text)
%     path     its folder, STORE/optim/.NAME/<name> (text)
%     keys     n x 1 cell, keys of the runs; task k is the k-th
%     folders  n x 1 cell, run folders
%
% The ledger is written before anything is sent, so no job can be in the queue
% of which it does not know.

function batches = batchLedger (store, name)
  place = fullfile (store, 'optim', ['.', name]);
  batches = struct ('name', {}, 'path', {}, 'keys', {}, 'folders', {});
  found = dir (place);
  for k = 1:numel (found)
    folder = fullfile (place, found(k).name);
    file = fullfile (folder, 'tasks');
    if found(k).name(1) == '.' || ~exist (file, 'file')
      continue
    end
    lines = regexp (fileread (file), '^([^\t\n]+)\t([^\n]+)$', ...
                    'tokens', 'lineanchors');
    lines = vertcat (cell (0, 2), lines{:});
    batches(end + 1) = struct ('name', found(k).name, 'path', folder, ...
                               'keys', {lines(:, 1)}, 'folders', {lines(:, 2)});
  end
end

%!test
%! store = tempname ();
%! mkdir (fullfile (store, 'optim', '.q', 'decalioc-1'));
%! mkdir (fullfile (store, 'optim', '.q', 'decalioc-2'));
%! place = fullfile (store, 'optim', '.q', 'decalioc-1');
%! fid = fopen (fullfile (place, 'tasks'), 'w');
%! fprintf (fid, "k1\t/a b/it's\nk2\t/c\n");
%! fclose (fid);
%! b = batchLedger (store, 'q');
%! assert (numel (b), 1);
%! assert (b.keys, {'k1'; 'k2'});
%! assert (b.folders, {'/a b/it''s'; '/c'});
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (store, 's');
%! assert (isempty (batchLedger (store, 'q')));
