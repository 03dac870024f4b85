% SESSIONNOTE  Says what is known of the difference between sessions.
%
% CALL: TEXT = sessionNote (CASE)
%
%   CASE  see newCase, with sessions
%   TEXT  one sentence without a full stop; '' where nothing was repeated
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
