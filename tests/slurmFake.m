% SLURMFAKE  Puts false programs of a queue in front of the real ones.
%
% CALL: TIDY = slurmFake (SEND, LOOK)
%       TIDY = slurmFake (SEND, LOOK, NAMES)
%
%   SEND, LOOK  lines of shell that the programs consist of (text)
%   NAMES       their names (default {'sbatch', 'squeue'})
%   TIDY        object that puts the PATH back when it is cleared
%
% See also: slurmExecutor

function tidy = slurmFake (send, look, names)
  if nargin < 3
    names = {'sbatch', 'squeue'};
  end
  folder = tempname ();
  mkdir (folder);
  programs = {names{1}, send; names{2}, look};
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

% SPDX-License-Identifier: GPL-3.0-only
