% EXECUTORNAMES  Names of all executors, found by their files.
%
% CALL: NAMES = executorNames ()
%
%   NAMES  1 x n cell: 'local' for executeLocal.m of executors/, 'slurm' for
%          slurmExecutor.m

function names = executorNames ()
  inside = fileparts (fileparts (mfilename ('fullpath')));
  files = readdir (fullfile (inside, 'executors'));
  found = regexp (files, '^execute([A-Z]\w*)\.m$|^(\w*)Executor\.m$', ...
                  'tokens', 'once');
  names = unique (cellfun (@(n) [lower(n(1)), n(2:end)], [found{:}], ...
                           'UniformOutput', false));
end

%!assert (all (ismember ({'local', 'static', 'slurm'}, executorNames ())))
%!assert (iscellstr (cellfun (@(n) describeExecutor (n).program, ...
%!                            executorNames (), 'UniformOutput', false)))
