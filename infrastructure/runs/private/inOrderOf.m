% INORDEROF  A job or record of a run with its parameters in the order of a case.
%
% CALL: JOB = inOrderOf (JOB, NAMES)
%
%   JOB    see newJobs, newRecord: variables holds each by its name; or []
%   NAMES  1 x d cell of names of parameters (Case.names)
%   JOB    as it was where one of them is none of its variables
%
% A run keeps its parameters in the order in which assign named them then.

function job = inOrderOf (job, names)
  if isempty (job) || numel (job.params) ~= numel (names)
    return
  end
  given = regexp (givenField (job, 'variables', ''), '\|(\w+)=([^|]+)', 'tokens');
  given = vertcat (cell (0, 2), given{:});
  [isThere, at] = ismember (names, given(:, 1));
  if all (isThere)
    job.params = reshape (str2double (given(at, 2)), size (job.params));
  end
end

%!test
%! job = struct ('params', [1, 2], 'variables', '|a=1|b=2|runSeed=3');
%! assert (inOrderOf (job, {'b', 'a'}).params, [2, 1]);
%! assert (inOrderOf (job, {'b', 'c'}), job);
%! assert (inOrderOf (job, {'b'}), job);
%! assert (inOrderOf (rmfield (job, 'variables'), {'b', 'a'}).params, [1, 2]);
%! assert (isempty (inOrderOf ([], {'a'})));

% SPDX-License-Identifier: GPL-3.0-only
