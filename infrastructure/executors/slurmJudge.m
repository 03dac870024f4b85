% SLURMJUDGE  Decides what has become of a submitted run.
%
% CALL: VERDICT = slurmJudge (REASON, STATE, AGE, GRACE, ISOLD)
%
%   REASON   third word of end.mark, '' = there is none (text)
%   STATE    Slurm's word for the job, '' = unknown to Slurm (text)
%   AGE      how long STATE has been one of an ended job, or end.mark has said
%            'killed' (s)
%   GRACE    how long the end mark of an ended job may take to appear (s)
%   ISOLD    the job was submitted by an earlier start of Octave (logical)
%   VERDICT  'wait'; 'collect' (it ended by itself or by its time limit: the
%            guard's word counts, whatever Slurm says); 'timeout' (Slurm's
%            limit); 'failed' (killed from outside); 'again' (killed or
%            cancelled while nobody watched: a new start submits it again)
%
% See also: slurmLook, slurmIsLive

function verdict = slurmJudge (reason, state, age, grace, isOld)
  isKilled = strcmp (reason, 'killed');
  if ~isempty (reason) && ~isKilled
    verdict = 'collect';
  elseif age < grace && (slurmIsLive (state) || ~isKilled)
    verdict = 'wait';
  elseif ~isKilled && slurmIsLive (state)
    verdict = 'wait';
  elseif any (strcmp (state, {'TIMEOUT', 'DEADLINE'}))
    verdict = 'timeout';
  elseif isOld
    verdict = 'again';
  else
    verdict = 'failed';
  end
end

%!assert (slurmJudge ('finished', 'RUNNING', 0, 30, false), 'collect')
%!assert (slurmJudge ('timeout', 'NODE_FAIL', 0, 30, true), 'collect')
%!assert (slurmJudge ('', 'RUNNING', Inf, 30, false), 'wait')
%!assert (slurmJudge ('', 'PENDING', Inf, 30, true), 'wait')
%! % Slurm says it has ended, the file server has not shown the mark yet
%!assert (slurmJudge ('', 'COMPLETED', 29, 30, false), 'wait')
%!assert (slurmJudge ('', 'COMPLETED', 30, 30, false), 'failed')
%!assert (slurmJudge ('', '', 29, 30, true), 'wait')
%!assert (slurmJudge ('', '', 30, 30, true), 'again')
%!assert (slurmJudge ('', 'NODE_FAIL', 30, 30, false), 'failed')
%!assert (slurmJudge ('', 'TIMEOUT', 30, 30, false), 'timeout')
%!assert (slurmJudge ('killed', 'COMPLETING', 1, 30, false), 'wait')
%!assert (slurmJudge ('killed', 'CANCELLED', 0, 30, false), 'failed')
%!assert (slurmJudge ('killed', 'CANCELLED', 0, 30, true), 'again')
%!assert (slurmJudge ('killed', 'TIMEOUT', 0, 30, true), 'timeout')
%! % Slurm believes in a job whose keeper was killed
%!assert (slurmJudge ('killed', 'RUNNING', 30, 30, false), 'failed')
