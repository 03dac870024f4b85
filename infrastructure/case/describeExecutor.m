% DESCRIBEEXECUTOR  What the rest of the toolbox has to know of an executor.
%
% CALL: WHAT = describeExecutor (NAME)
%
%   NAME  name of the executor (text): Input.executor
%   WHAT  scalar struct:
%     check    handle P = check (GIVEN): faults of Input.<name>, see
%              checkFault; [] where the executor has no fields of its own
%     program  program that must be on the PATH, '' = none
%     isHere   logical: the runs are made on this machine
%     execute  handle RECORDS = execute (JOBS, CASE, REPORT), see executeLocal
%     sets     handle N = sets (OPTIONS): parameter sets that the calibration
%              tries at a time after the plan; OPTIONS is Case.options
%
% An executor is a function execute<Name>. One that differs from these defaults
% has a function <name>Executor that returns its own; the other may be missing
% then, as for slurmExecutor. Other fields are its own matter.
%
% See also: executorNames, runJobs

function what = describeExecutor (name)
  what = struct ('check', [], 'program', '', 'isHere', true, ...
                 'sets', @(options) max (1, floor (options.maxCPU)));
  if ~isempty (name)
    what.execute = str2func (['execute', upper(name(1)), name(2:end)]);
  end
  maker = [name, 'Executor'];
  if isvarname (maker) && exist (maker, 'file') == 2
    what = mergeFields (what, feval (maker));
  end
end

%!test
%! what = describeExecutor ('local');
%! assert (what.isHere && isempty (what.check));
%! assert (what.sets (struct ('maxCPU', 5)), 5);
%! assert (describeExecutor ('slurm').program, 'sbatch');
%!test
%! % of whatever name
%! assert (describeExecutor ('a b').program, '');

% SPDX-License-Identifier: GPL-3.0-only
