% BATCHDISCARD  Removes the folder of a batch.
%
% CALL: batchDiscard (FOLDER)
%
%   FOLDER  folder <store>/optim/.<queue>/<name> (text)
%
% It is renamed first: at no moment is a half of it taken for the whole.
% Without its folder an array can start nothing: batchTask.sh finds no run.

function batchDiscard (folder)
  confirm_recursive_rmdir (false, 'local');
  aside = draftName (fullfile (fileparts (folder), '.ended'));
  if rename (folder, aside) == 0
    [~, ~] = rmdir (aside, 's');
  end
end

%!test
%! store = tempname ();
%! folder = fullfile (store, 'decalioc-1');
%! mkdir (folder);
%! writeAtomic (fullfile (folder, 'tasks'), 'x');
%! batchDiscard (folder);
%! assert (readdir (store), {'.'; '..'});
%! batchDiscard (folder);

% SPDX-License-Identifier: GPL-3.0-only
