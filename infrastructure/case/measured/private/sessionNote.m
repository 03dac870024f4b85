% SESSIONNOTE  Says what is known of the difference between sessions.
%
% CALL: TEXT = sessionNote (CASE)
%
%   CASE  see newCase, with sessions
%   TEXT  sentences without the last full stop; '' where nothing was repeated. What
%         drifts within a session comes first (driftNote)
%
% Trials that follow one another share the weather, the hand, the filling of the
% day. On rigs on which nothing was changed two sessions differ by more than
% their own trials tell.

function text = sessionNote (Case)
  text = '';
  sessions = Case.sessions;
  advice = ['trials of one session understate what changes from day to day: ' ...
            'repeat the reference on another day'];
  if sessions.df > 0
    text = sprintf (['sessions differ by %.1f times the scatter of a trial ' ...
                     'within one (%d sessions of the reference, column ' ...
                     'session of measured.csv)'], sessions.ratio, ...
                    numel (sessions.names));
  elseif sessions.given
    text = sprintf (['%s. Until then sessions are taken to differ by %.1f ' ...
                     'times the scatter of a trial, as on other rigs'], ...
                    advice, sessions.ratio);
  elseif any ([Case.targets.trials] > 1)
    text = [advice, ', and name the days in a column session of measured.csv'];
  end
  least = leastSeen (Case);
  if ~isempty (text) && ~isempty (least)
    text = sprintf (['%s. A change of a reading by %.2g of its tolerances ' ...
                     '(median) would show in 8 of 10 cases'], text, median (least));
  end
  drift = driftNote (sessions);
  if isempty (text) || isempty (drift)
    text = [drift, text];
  else
    text = [drift, '. ', upper(text(1)), text(2:end)];
  end
end

% Changes that one reading alone would show, in its tolerances.
function least = leastSeen (Case)
  least = zeros (1, 0);
  for c = 1:numel (givenField (Case, 'conditions', {}))
    for target = Case.targets
      now = target.changed(c);
      allowed = target.tol * abs (target.value);
      if target.isAbsolute
        allowed = target.tol;
      end
      if target.sd > 0 && now.sd > 0 && allowed > 0
        [~, ~, seen] = sdOfChange (target, now);
        least(end + 1) = seen / allowed;
      end
    end
  end
end

%!function text = of (given, df, trials)
%!  Case.sessions = struct ('given', given, 'names', {{'a', 'b'}}, ...
%!                          'ratio', 2.5 * given, 'df', df);
%!  Case.targets = struct ('trials', {1, trials});
%!  text = sessionNote (Case);
%!endfunction
%!assert (of (false, 0, 1), '')
%!assert (of (false, 0, 3), ['trials of one session understate what changes ' ...
%!        'from day to day: repeat the reference on another day, and name ' ...
%!        'the days in a column session of measured.csv'])
%!assert (! isempty (strfind (of (true, 0, 1), 'taken to differ by 2.5')))
%!assert (! isempty (strfind (of (true, 3, 1), '2 sessions of the reference')))
%!test
%! % what can be seen of a change
%! one = struct ('sd', 1, 'shared', 0, 'days', [], 'freedom', Inf, ...
%!               'commonFreedom', Inf, 'sessionFreedom', Inf);
%! Case.sessions = struct ('given', true, 'names', {{'a'}}, 'ratio', 2.5, ...
%!                         'df', 0);
%! Case.targets = mergeFields (one, struct ('trials', 3, 'changed', one, 'tol', ...
%!                                          0.1, 'isAbsolute', false, 'value', 10));
%! Case.conditions = {'moist'};
%! assert (! isempty (strfind (sessionNote (Case), 'by 4 of its tol')));

% SPDX-License-Identifier: GPL-3.0-only
