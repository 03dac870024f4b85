% SLURMTESTREADY  Says whether a test cluster can be started here.
%
% CALL: READY = slurmTestReady ()
%       READY = slurmTestReady ('quiet')
%
%   READY  logical; false, and a line on stdout that says why, where Slurm or
%          munge are not installed or this is not root
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
  end
  ready = isempty (why);
  if ~ready && nargin == 0
    printf ('tests with Slurm are skipped: %s\n', why);
  end
end
