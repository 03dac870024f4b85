% BATCHJUDGE  Decides what has become of a submitted run.
%
% CALL: VERDICT = batchJudge (REASON, STATE, AGE, GRACE, ISOLD)
%
%   REASON   third word of end.mark, '' = there is none (text)
%   STATE    what the queue says of the job (char): 'p' it waits, 'r' it runs or
%            may still do something, 't' ended at the queue's time limit, 'e'
%            ended, '-' unknown to the queue, '?' the queue did not answer
%   AGE      how long STATE has been one of an ended job, or end.mark has said
%            'killed' (s)
%   GRACE    how long the end mark of an ended job may take to appear (s)
%   ISOLD    the job was submitted by an earlier start of Octave (logical)
%   VERDICT  'wait'; 'collect' (it ended by itself or by its time limit: the
%            guard's word counts, whatever the queue says); 'timeout' (the
%            queue's limit); 'failed' (killed from outside); 'again' (killed or
%            cancelled while nobody watched: a new start submits it again)

function verdict = batchJudge (reason, state, age, grace, isOld)
  isLive = any (state == 'pr?');
  isKilled = strcmp (reason, 'killed');
  if ~isempty (reason) && ~isKilled
    verdict = 'collect';
  elseif age < grace && (isLive || ~isKilled)
    verdict = 'wait';
  elseif ~isKilled && isLive
    verdict = 'wait';
  elseif state == 't'
    verdict = 'timeout';
  elseif isOld
    verdict = 'again';
  else
    verdict = 'failed';
  end
end

%!assert (batchJudge ('finished', 'r', 0, 30, false), 'collect')
%!assert (batchJudge ('timeout', 'e', 0, 30, true), 'collect')
%!assert (batchJudge ('', 'r', Inf, 30, false), 'wait')
%!assert (batchJudge ('', 'p', Inf, 30, true), 'wait')
%! % the queue says it has ended, the file server has not shown the mark yet
%!assert (batchJudge ('', 'e', 29, 30, false), 'wait')
%!assert (batchJudge ('', 'e', 30, 30, false), 'failed')
%!assert (batchJudge ('', '-', 29, 30, true), 'wait')
%!assert (batchJudge ('', '-', 30, 30, true), 'again')
%!assert (batchJudge ('', 'e', 30, 30, false), 'failed')
%!assert (batchJudge ('', 't', 30, 30, false), 'timeout')
%!assert (batchJudge ('killed', 'r', 1, 30, false), 'wait')
%!assert (batchJudge ('killed', 'e', 0, 30, false), 'failed')
%!assert (batchJudge ('killed', 'e', 0, 30, true), 'again')
%!assert (batchJudge ('killed', 't', 0, 30, true), 'timeout')
%! % the queue believes in a job whose keeper was killed
%!assert (batchJudge ('killed', 'r', 30, 30, false), 'failed')
