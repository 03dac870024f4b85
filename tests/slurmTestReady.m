% SLURMTESTREADY  Says whether a test cluster can be started here.
%
% CALL: READY = slurmTestReady ()
%       READY = slurmTestReady ('quiet')
%
%   READY  logical; false, and a line on stdout that says why, where Slurm or
%          munge are not installed, this is not root, or the daemons do not
%          start (as in a bare chroot). With CI=true in the environment the
%          last is not tried: there it is a failure of the tests
%
% The trial is made once; its outcome stays in DECALIOC_SLURM_TRIAL.
%
% See also: slurmTestUp

function ready = slurmTestReady (varargin)
  places = [getenv('PATH'), ':/usr/sbin:/sbin'];
  programs = {'slurmctld', 'slurmd', 'munged', 'sbatch', 'squeue'};
  isAbsent = cellfun (@(p) isempty (file_in_path (places, p)), programs);
  why = '';
  if any (isAbsent)
    why = sprintf (['%s not found, install slurm-wlm and munge (apt-get ' ...
                    'install slurm-wlm munge)'], ...
                   strjoin (programs(isAbsent), ', '));
  elseif getuid () ~= 0
    why = 'a test cluster can be started by root only';
  elseif ~startsOnce ()
    why = 'its daemons do not come up on this machine';
  end
  ready = isempty (why);
  if ~ready && nargin == 0
    printf ('tests with Slurm are skipped: %s\n', why);
  end
end

function yes = startsOnce ()
  if isempty (getenv ('DECALIOC_SLURM_TRIAL')) && isempty (getenv ('CI'))
    setenv ('DECALIOC_SLURM_TRIAL', trial ());
  end
  yes = ~strcmp (getenv ('DECALIOC_SLURM_TRIAL'), 'failed');
end

function outcome = trial ()
  config = getenv ('SLURM_CONF');
  down = fullfile (fileparts (mfilename ('fullpath')), 'slurm-down.sh');
  try
    folder = slurmTestUp (2);
    [~, ~] = system ([shellQuote(down), ' ', shellQuote(folder), ' 2>&1']);
    outcome = 'passed';
  catch
    outcome = 'failed';
  end
  setenv ('SLURM_CONF', config);
end

% SPDX-License-Identifier: GPL-3.0-only
