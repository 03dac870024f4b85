% SLURMFAKE  Puts a false sbatch and a false squeue in front of the real ones.
%
% CALL: TIDY = slurmFake (SBATCH, SQUEUE)
%
%   SBATCH, SQUEUE  lines of shell that they consist of (text)
%   TIDY            object that puts the PATH back when it is cleared
%
% See also: slurmSend, slurmLook

function tidy = slurmFake (sbatch, squeue)
  folder = tempname ();
  mkdir (folder);
  programs = {'sbatch', sbatch; 'squeue', squeue};
  for k = 1:2
    file = fullfile (folder, programs{k, 1});
    writeAtomic (file, sprintf ("#!/bin/bash\n%s\n", programs{k, 2}));
    system (['chmod +x ', shellQuote(file)]);
  end
  before = getenv ('PATH');
  setenv ('PATH', [folder, ':', before]);
  tidy = onCleanup (@() putBack (before, folder));
end

function putBack (before, folder)
  setenv ('PATH', before);
  confirm_recursive_rmdir (false, 'local');
  rmdir (folder, 's');
end
