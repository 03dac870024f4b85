% SLURMVOID  Gives a run up: no job of any array can start it any more.
%
% CALL: slurmVoid (FOLDER)
%
%   FOLDER  run folder (text)
%
% Takes the claim that slurmTask.sh needs, or marks the one there as void.
%
% See also: slurmAttach, executeSlurm

function slurmVoid (folder)
  claim = fullfile (folder, 'slurm.claim');
  [~, ~] = mkdir (claim);
  fid = fopen (fullfile (claim, 'void'), 'w');
  if fid >= 0
    fclose (fid);
  end
end

%!test
%! folder = tempname ();
%! mkdir (folder);
%! slurmVoid (folder);
%! slurmVoid (folder);
%! assert (exist (fullfile (folder, 'slurm.claim', 'void'), 'file'), 2);
%! script = fullfile (fileparts (which ('slurmVoid')), 'slurmTask.sh');
%! fid = fopen (fullfile (folder, 'tasks'), 'w');
%! fprintf (fid, "key\t%s\n", folder);
%! fclose (fid);
%! line = ['SLURM_ARRAY_TASK_ID=%d SLURM_ARRAY_JOB_ID=1 bash %s %s true ', ...
%!         '2> /dev/null'];
%! run = @(k) system (sprintf (line, k, shellQuote (script), folder));
%! assert (run (1), 94);
%! assert (run (2), 95);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (fullfile (folder, 'slurm.claim'), 's');
%! fid = fopen (fullfile (folder, 'true'), 'w');
%! fclose (fid);
%! assert (run (1), 0);
%! assert (fileread (fullfile (folder, 'slurm.claim', 'who')), "1_1 on ?\n");
%! assert (run (1), 94);
%! rmdir (folder, 's');
