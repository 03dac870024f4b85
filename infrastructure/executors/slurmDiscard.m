% SLURMDISCARD  Removes the folder of a batch.
%
% CALL: slurmDiscard (FOLDER)
%
%   FOLDER  folder <store>/optim/.slurm/<name> (text)
%
% It is renamed first: at no moment is a half of it taken for the whole.
% Without its folder an array can start nothing: slurmTask.sh finds no run.
%
% See also: slurmRetire, slurmAttach

function slurmDiscard (folder)
  confirm_recursive_rmdir (false, 'local');
  aside = fullfile (fileparts (folder), '.ended');
  [~, ~] = rename (folder, aside);
  [~, ~] = rmdir (aside, 's');
end

%!test
%! store = tempname ();
%! folder = fullfile (store, 'decalioc-1');
%! mkdir (folder);
%! writeAtomic (fullfile (folder, 'tasks'), 'x');
%! slurmDiscard (folder);
%! assert (readdir (store), {'.'; '..'});
%! slurmDiscard (folder);
%! rmdir (store);
