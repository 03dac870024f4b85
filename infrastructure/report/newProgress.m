% NEWPROGRESS  Makes the function that reports how a stage goes.
%
% CALL: REPORT = newProgress (STAGE, SAY)
%
%   STAGE   what is going on (text)
%   SAY     function handle that takes one line of text
%   REPORT  function handle for runJobs: says how many runs are done, failed,
%           running and reused, and the time left, at most once a second;
%           a message of the executor (a cluster that does not answer) at once

function report = newProgress (stage, say)
  said = -Inf;                       % when: the nested function remembers it
  report = @tell;

  function tell (state)
    if isfield (state, 'message') && ~isempty (state.message)
      say (['  ', state.message]);
      if state.total == 0                  % it waits, see waitForRuns
        return
      end
    end
    if (state.done == state.total || time () - said >= 1) && ...
       (state.total > 0 || state.reused > 0)
      said = time ();
      say (textOf (state, stage));
    end
  end

end

function text = textOf (state, stage)
  text = sprintf ('  %s: %d of %d runs done', stage, state.done, state.total);
  if state.failed > 0
    text = sprintf ('%s, %d failed', text, state.failed);
  end
  if state.reused > 0
    text = sprintf ('%s, %d taken from the store', text, state.reused);
  end
  if state.done < state.total && state.done > 0
    % on average the runs under way are half done
    done = state.done + state.running / 2;
    left = state.seconds / done * (state.total - done);
    text = sprintf ('%s, %d running, about %s left', text, state.running, ...
                    inWords (left));
  end
  if state.total == 0
    text = sprintf ('  %s: all %d runs are in the store', stage, state.reused);
  end
end

%!test
%! report = newProgress ('plan', @disp);
%! state = struct ('done', 2, 'total', 10, 'failed', 1, 'running', 2, ...
%!                 'reused', 0, 'seconds', 20);
%! assert (evalc ('report (state)'), ['  plan: 2 of 10 runs done, 1 ', ...
%!         "failed, 2 running, about 47 s left\n"]);
%! state.message = 'no answer';
%! assert (evalc ('report (state)'), "  no answer\n");
