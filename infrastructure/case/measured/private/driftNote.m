% DRIFTNOTE  Says what drifts with the order of trials.
%
% CALL: TEXT = driftNote (SESSIONS)
%
%   SESSIONS  of groupMeasured
%   TEXT      sentences without the last full stop; '' where nothing drifts
%
% See also: withoutDrift

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
    end
  end
  text = strjoin (said, '. ');
end

%!assert (driftNote (struct ('given', true)), '')
%!test
%! drift = struct ('session', {'mon', ''}, 'name', {'a', 'w'}, 'slope', {0.3, -0.02}, ...
%!                 'p', {2e-4, 0.003}, 'oneWay', {{}, {'moist'}});
%! text = driftNote (struct ('drifts', drift));
%! assert (text, ['a drifts with the order of trials in mon (+0.3 each, p = 0.0002). ' ...
%!                'w drifts with the order of trials (-0.02 each, p = 0.003): no ' ...
%!                'cause is named from it, for moist was read only before or only ' ...
%!                'after the reference. Read both in turn']);

% SPDX-License-Identifier: GPL-3.0-only
