% MADEBYTEXT  Says which causes may have made the effects, and what to ask.
%
% CALL: TEXT = madeByText (GAP, CAUSE)
%
%   GAP    decoded gap/gap.json: which.cause, of weighCauses; reference.origin, what the
%          user says it was
%   CAUSE  see decideGap
%   TEXT   two sentences; '' where nothing is known
%
% Only where the verdict says an effect, and only those that an effect with a tenth
% of the probability supports.

function text = madeByText (gap, cause)
  origin = char (jsonAt (gap, {'reference', 'origin'}));
  text = '';
  if ~isempty (origin)
    text = sentence ('cause.origin', struct ('origin', origin));
    return
  end
  list = jsonList (gap, {'which', 'cause'});
  speaks = {'named', 'alike', 'likely', 'several', 'sameKind', 'kind', 'atEnd'};
  if isempty (list) || ~any (strcmp (cause.code, speaks))
    return
  end
  p = cellfun (@(c) c.probability, list);
  isShown = p >= max (0.05, p(min (3, end))) & ...
            cellfun (@(c) isempty (c.name) || isCarried (c, gap), list);
  shown = list(isShown);
  named = shown(cellfun (@(c) ~isempty (c.name), shown));
  if isempty (named)
    return
  end
  parts = eachOf (@(c) [c.label, ' ', plainNumber(c.probability, 'probability')], shown);
  text = [sentence('cause.madeBy', struct ('list', strjoin (parts, ', '))), ' ', ...
          sentence('cause.ask', named{1})];
end

function yes = isCarried (cause, gap)
  p = cellfun (@(n) max ([jsonAt(gap, {'which', 'posterior', ...
                                       matlab.lang.makeValidName(n)}), 0]), ...
               namesIn (cause, 'effects'));
  yes = any (p >= 0.1);
end

%!shared gap, said
%! list = struct ('name', {'moisture', '', 'batch'}, 'label', ...
%!                {'moisture of the grains', 'none of these', 'another batch'}, ...
%!                'question', {'Have the grains become moist?', '', 'b?'}, ...
%!                'probability', {0.8, 0.17, 0.03}, 'effects', {'cohesion', {}, 'shape'});
%! gap.which = struct ('cause', list, 'posterior', struct ('cohesion', 0.9, 'shape', 0.5));
%! said = @(gap, code) madeByText (gap, struct ('code', code));
%!assert (said (gap, 'likely'), ['Possible origin: moisture of the ' ...
%!        'grains 0.80, none of these 0.17. Ask first: Have the grains become moist?'])
%!assert (said (gap, 'oneNumber'), '')
%!test
%! % no effect carries it; what the user says
%! gap.which.posterior.cohesion = 0.04;
%! assert (said (gap, 'likely'), '');
%! gap.reference.origin = 'another batch';
%! assert (said (gap, 'likely'), 'You say what it was: another batch.');
%!assert (said (struct ('which', struct ('cause', [])), 'named'), '')

% SPDX-License-Identifier: GPL-3.0-only
