% NEWPROGRESS  Makes the function that reports how a stage goes.
%
% CALL: REPORT = newProgress (STAGE, SAY [, FURTHER])
%
%   STAGE   what is going on (text)
%   SAY     function handle that takes one line of text
%   REPORT  function handle for runJobs: says how many runs are done, failed,
%           running and reused, and the time left (and in all, where FURTHER
%           runs may follow), at most once a second, at a terminal in one place;
%           a message of the executor (a cluster that does not answer) at once

function report = newProgress (stage, say, further)
  if nargin < 3
    further = 0;
  end
  move = say;
  if takesClass (say)
    move = @(text) say (text, 'moving');
  end
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
      if state.done < state.total
        move (textOf (state, stage, further));
      else
        say (textOf (state, stage, further));
      end
    end
  end

end

% The handle of newSay does; that of a builtin function has no number.
function yes = takesClass (say)
  try
    yes = nargin (say) == -2;
  catch
    yes = false;
  end
end

function text = textOf (state, stage, further)
  text = sprintf ('  %s: %d of %s done', stage, state.done, countText (state.total, 'run'));
  if state.failed > 0
    text = sprintf ('%s, %d failed', text, state.failed);
  end
  if state.reused > 0
    text = sprintf ('%s, %d made earlier', text, state.reused);
  end
  if state.done < state.total && state.done > 0
    % on average the runs under way are half done
    done = state.done + state.running / 2;
    left = state.seconds / done * (state.total - done);
    text = sprintf ('%s, %d running, about %s left', text, state.running, ...
                    inWords (left));
    if further > 0
      text = sprintf ('%s, at most %s in all', text, ...
                      inWords (left + state.seconds / done * further));
    end
  end
  if state.total == 0
    text = sprintf ('  %s: %s made earlier', stage, ...
                    countText (state.reused, 'run was', 'runs were all'));
  end
end

%!test
%! report = newProgress ('plan', @disp);
%! state = struct ('done', 2, 'total', 10, 'failed', 1, 'running', 2, ...
%!                 'reused', 0, 'seconds', 20);
%! assert (evalc ('report (state)'), ['  plan: 2 of 10 runs done, 1 ', ...
%!         "failed, 2 running, about 47 s left\n"]);
%! further = newProgress ('plan', @disp, 90);
%! assert (! isempty (regexp (evalc ('further (state)'), 'left, at most \d+ min in all')));
%! state.message = 'no answer';
%! assert (evalc ('report (state)'), "  no answer\n");

% SPDX-License-Identifier: GPL-3.0-only
