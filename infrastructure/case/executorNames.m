% EXECUTORNAMES  Names of all executors, found by their files.
%
% CALL: NAMES = executorNames ()
%       NAMES = executorNames ('described')
%
%   NAMES  1 x n cell: 'local' for executeLocal.m of runs/executors/, 'slurm'
%          for slurmExecutor.m of its queues/, 'static' for executeStatic.m of
%          runs/published/; of those described the ones with a file NAMEExecutor.m

function names = executorNames (kind)
  inside = fileparts (fileparts (mfilename ('fullpath')));
  folders = fullfile (inside, {'runs/executors', 'runs/executors/queues', ...
                               'runs/published'});
  files = cellfun (@(f) readdir (f)', folders(isfolder (folders)), ...
                   'UniformOutput', false);
  pattern = '^execute([A-Z]\w*)\.m$|^(\w*)Executor\.m$';
  if nargin > 0
    pattern = '^(\w*)Executor\.m$';
  end
  found = regexp ([files{:}], pattern, 'tokens', 'once');
  names = unique (cellfun (@(n) [lower(n(1)), n(2:end)], [found{:}], ...
                           'UniformOutput', false));
end

%!assert (all (ismember ({'local', 'static', 'slurm'}, executorNames ())))
%!assert (executorNames ('described'), {'gridengine', 'slurm'})
%!assert (iscellstr (cellfun (@(n) describeExecutor (n).program, ...
%!                            executorNames (), 'UniformOutput', false)))

% SPDX-License-Identifier: GPL-3.0-only
