% READINGNOTES  What is known of the scatter of readings, in sentences.
%
% CALL: NOTES = readingNotes (CASE)
%
%   CASE   see newCase
%   NOTES  1 x n struct array: label ('sessions', 'scatter'), text (a sentence
%          without a full stop); empty where nothing is known

function notes = readingNotes (Case)
  notes = struct ('label', {'sessions', 'scatter'}, ...
                  'text', {sessionNote(Case), scatterNote(Case)});
  notes = notes(~cellfun (@isempty, {notes.text}));
end

% What is known of the difference between sessions, after what drifts within one. Trials
% that follow one another share the weather, the hand, the filling of the day: on rigs on
% which nothing was changed two sessions differ by more than their own trials tell.
function text = sessionNote (Case)
  text = '';
  sessions = Case.sessions;
  isChange = ~isempty (givenField (Case, 'conditions', {}));
  trials = [Case.targets.trials];
  if isChange
    now = [Case.targets.changed];
    trials = [trials, now.trials];
  end
  advice = ['the trials do not tell how much days differ: repeat the reference on ' ...
            'another day'];
  if givenField (sessions, 'known', false)
    text = '';                           % sessionSd and repeats = Inf say it
  elseif sessions.df > 0
    text = sprintf (['sessions differ by %.1f times the scatter of a trial ' ...
                     'within one (column session of measured.csv)'], sessions.ratio);
  elseif sessions.given
    text = sprintf (['%s. Until then sessions are taken to differ by %.1f ' ...
                     'times the scatter of a trial, as on other rigs'], ...
                    advice, sessions.ratio);
  elseif any (trials > 1) && isChange
    text = [advice, ', and name the days in a column session of measured.csv'];
  elseif any (trials > 1)
    text = ['if you measured on several days, write the day of each line into a column ' ...
            'session of measured.csv; else you have nothing to do'];
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

% What drifts with the order of trials, see withoutDrift; '' where nothing does.
function text = driftNote (sessions)
  said = {};
  for drift = givenField (sessions, 'drifts', [])
    of = '';
    if ~isempty (drift.session)
      of = [' in ', drift.session];
    end
    said{end + 1} = sprintf (['%s drifts with the order of trials%s (%+.2g each, ' ...
                              'p = %.1g)'], drift.name, of, drift.slope, drift.p);
    if ~isempty (drift.oneWay)
      said{end} = sprintf (['%s: no cause is named from it, for %s was read only ' ...
                            'before or only after the reference. Read both in turn'], ...
                           said{end}, strjoin (drift.oneWay, ' and '));
    elseif drift.isAgain
      said{end} = [said{end}, '. Both states have the same numbers there, as if read at ' ...
                   'one time: count the trials of a session on from one state to the next'];
    end
  end
  text = strjoin (said, '. ');
end

% Which readings scatter otherwise after the change, see scatterOfChange: a fault of an
% instrument, a loose part, grains that stick and slip. A wrong gain scatters as before.
function text = scatterNote (Case)
  said = {};
  for c = 1:numel (Case.conditions)
    for target = Case.targets
      now = target.changed(c);
      if givenField (now, 'scatterP', NaN) < 0.01
        said{end + 1} = sprintf ('%s %.2g times as much in %s (p %s)', ...
                                 target.name, now.scatterRatio, ...
                                 Case.conditions{c}, pText (now.scatterP));
      end
    end
  end
  text = '';
  if ~isempty (said)
    text = ['trials scatter otherwise than in the reference: ', ...
            strjoin(said, ', ')];
  end
end

function text = pText (p)
  text = sprintf ('= %.1g', p);
  if p < 0.001
    text = '< 0.001';
  end
end

%!function text = noteOf (label, Case)
%!  Case = mergeFields (struct ('conditions', {{}}, 'sessions', struct ()), Case);
%!  notes = readingNotes (mergeFields (Case, struct ('sessions', mergeFields ( ...
%!    struct ('df', 0, 'ratio', 0, 'given', false, 'names', {{'a', 'b'}}), ...
%!    Case.sessions))));
%!  text = [notes(strcmp ({notes.label}, label)).text];
%!endfunction
%!function text = of (given, df, trials)
%!  Case.sessions = struct ('given', given, 'ratio', 2.5 * given, 'df', df);
%!  Case.targets = struct ('trials', {1, trials});
%!  text = noteOf ('sessions', Case);
%!endfunction
%!test
%! Case = readyCase ();
%! Case.sessions = struct ('df', 1, 'ratio', 2, 'given', false);
%! notes = readingNotes (Case);
%! assert ({notes.label}, {'sessions'});
%! assert (strncmp (notes.text, 'sessions differ by 2.0 times', 28));
%!assert (isempty (of (false, 0, 1)))
%!assert (of (false, 0, 3), ['if you measured on several days, write the day of each ' ...
%!        'line into a column session of measured.csv; else you have nothing to do'])
%!test
%! % a reading of either state that was repeated tells no days
%! Case = struct ('targets', struct ('trials', 1, 'changed', struct ('sd', 0, 'trials', 3), ...
%!                                   'tol', 1, 'isAbsolute', true, 'sd', 0, 'value', 1), ...
%!                'conditions', {{'moist'}});
%! assert (noteOf ('sessions', Case), ['the trials do not tell how much days differ: ' ...
%!         'repeat the reference on another day, and name the days in a column session ' ...
%!         'of measured.csv']);
%!assert (! isempty (strfind (of (true, 0, 1), 'taken to differ by 2.5')))
%!assert (! isempty (strfind (of (true, 3, 1), 'sessions differ by 2.5 times')))
%!test
%! % what can be seen of a change
%! one = struct ('sd', 1, 'shared', 0, 'days', [], 'freedom', Inf, 'trials', 1, ...
%!               'commonFreedom', Inf, 'sessionFreedom', Inf);
%! Case.sessions = struct ('given', true, 'ratio', 2.5);
%! Case.targets = mergeFields (one, struct ('trials', 3, 'changed', one, 'tol', ...
%!                                          0.1, 'isAbsolute', false, 'value', 10));
%! Case.conditions = {'moist'};
%! assert (! isempty (strfind (noteOf ('sessions', Case), 'by 4 of its tol')));
%!test
%! % what drifts comes first
%! Case.sessions.drifts = struct ('session', {'mon', ''}, 'name', {'a', 'w'}, 'slope', ...
%!                                {0.3, -0.02}, 'p', {2e-4, 0.003}, 'oneWay', ...
%!                                {{}, {'moist'}}, 'isAgain', false);
%! Case.targets.trials = 1;
%! drift = ['a drifts with the order of trials in mon (+0.3 each, p = 0.0002). ' ...
%!          'w drifts with the order of trials (-0.02 each, p = 0.003): no ' ...
%!          'cause is named from it, for moist was read only before or only ' ...
%!          'after the reference. Read both in turn'];
%! assert (noteOf ('sessions', Case), drift);
%! Case.targets.trials = 3;
%! assert (strncmp (noteOf ('sessions', Case), [drift, '. If you'], numel (drift) + 8));
%! Case.sessions.drifts(1).isAgain = true;
%! assert (! isempty (strfind (noteOf ('sessions', Case), 'count the trials of a session')));
%!test
%! changed = @(p) struct ('scatterRatio', 9, 'scatterP', p, 'trials', 1);
%! Case.targets = struct ('name', {'a', 'b', 'c'}, 'trials', 1, 'tol', 1, 'value', 0, ...
%!                        'sd', 0, 'isAbsolute', false, 'changed', ...
%!                        {changed(1e-5), changed(0.2), changed(0.004)});
%! Case.conditions = {'moist'};
%! assert (noteOf ('scatter', Case), ['trials scatter otherwise than in the ' ...
%!         'reference: a 9 times as much in moist (p < 0.001), c 9 times as ' ...
%!         'much in moist (p = 0.004)']);
%! Case.targets = Case.targets(2);
%! assert (isempty (noteOf ('scatter', Case)));

% SPDX-License-Identifier: GPL-3.0-only
