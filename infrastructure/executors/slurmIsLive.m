% SLURMISLIVE  Says whether a job in this state may still do something.
%
% CALL: LIVE = slurmIsLive (STATE)
%
%   STATE  state of a job as squeue writes it, '' = unknown to Slurm (text, or
%          cell of n texts)
%   LIVE   logical, as many; true also for states that a future Slurm invents
%
% See also: slurmParse, slurmJudge

function live = slurmIsLive (state)
  ended = {'', 'BOOT_FAIL', 'CANCELLED', 'COMPLETED', 'DEADLINE', ...
           'FAILED', 'NODE_FAIL', 'OUT_OF_MEMORY', 'PREEMPTED', ...
           'REVOKED', 'TIMEOUT'};
  live = ~ismember (state, ended);
end

%!assert (slurmIsLive ({'RUNNING', 'COMPLETING', 'NODE_FAIL', ''}), ...
%!        [true, true, false, false])
%!assert (slurmIsLive ('PENDING'))
