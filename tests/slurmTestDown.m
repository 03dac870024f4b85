% SLURMTESTDOWN  Stops a test cluster and removes its folder.
%
% CALL: slurmTestDown (FOLDER)
%
%   FOLDER  see slurmTestUp
%
% See also: slurmTestUp

function slurmTestDown (folder)
  script = fullfile (fileparts (mfilename ('fullpath')), 'slurm-down.sh');
  system ([shellQuote(script), ' ', shellQuote(folder)]);
  confirm_recursive_rmdir (false, 'local');
  rmdir (folder, 's');
end

% SPDX-License-Identifier: GPL-3.0-only
