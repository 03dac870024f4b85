% SLURMTESTUP  Starts a test cluster that goes down with this Octave.
%
% CALL: FOLDER = slurmTestUp (CPUS)
%       FOLDER = slurmTestUp (CPUS, NODES)
%
%   CPUS    processors that each node pretends to have
%   NODES   number of nodes n1, n2 ... (default 1)
%   FOLDER  folder of the cluster (text); stop it with slurm-down.sh FOLDER
%
% Sets the environment variable SLURM_CONF.
%
% See also: slurmTestReady

function folder = slurmTestUp (cpus, nodes)
  if nargin < 2
    nodes = 1;
  end
  folder = tempname (P_tmpdir (), 'slurm-');
  script = fullfile (fileparts (mfilename ('fullpath')), 'slurm-up.sh');
  [status, text] = system (sprintf (['SLURM_TEST_CPUS=%d ' ...
                                     'SLURM_TEST_NODES=%d %s %s %d 2>&1'], ...
                                    cpus, nodes, shellQuote (script), ...
                                    folder, getpid ()));
  if status ~= 0
    error ('DEcalioc:slurmTestUp:runFailed', ...
           'slurmTestUp: the test cluster must start, got: %s', text);
  end
  setenv ('SLURM_CONF', fullfile (folder, 'slurm.conf'));
  setenv ('PATH', [getenv('PATH'), ':/usr/sbin:/sbin']);
end

% SPDX-License-Identifier: GPL-3.0-only
