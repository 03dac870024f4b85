% ASKCHANGE  Asks of each candidate whether it can have changed.
%
% CALL: LINES = askChange (CASE)
%
%   CASE   see newCase, with effects and unchanged of withEffects
%   LINES  1 x n cell of texts: how each candidate is taken, and a question as
%          long as loadEffects.m does not answer for all of them

function lines = askChange (Case)
  lines = {sprintf('change    from the reference to %s', ...
                   strjoin (Case.conditions, ', '))};
  if isempty (Case.effects)
    return
  end
  words = changeWords (Case.effects);
  taken = {'can have changed', {Case.effects(strcmp (words, 'yes')).name}; ...
           'unlikely to have changed, 0.05 as likely as those above', ...
           {Case.effects(strcmp (words, 'unlikely')).name}; ...
           'cannot have changed, left out', Case.unchanged};
  for row = taken(~cellfun (@isempty, taken(:, 2)), :)'
    lines{end + 1} = sprintf ('          %s: %s', row{1}, ...
                              strjoin (row{2}, ', '));
  end
  isOpen = cellfun (@isempty, {Case.effects.canChange});
  if any (isOpen)
    answers = 'effects(1).canChange = ''yes'', ''unlikely'' or ''no''';
    lines = [lines, ...
             {['          Are these the same grains? Is the rig as it was? ' ...
               'Say of each candidate in loadEffects.m'], ...
              sprintf('          whether it can have changed: %s.', answers), ...
              sprintf('          Not said of: %s', ...
                      strjoin ({Case.effects(isOpen).name}, ', '))}];
  end
end

%!function lines = asked (varargin)
%!  Case = readyCase ();
%!  Case.conditions = {'moist'};
%!  lines = askChange (withEffects (Case, varargin));
%!endfunction
%!test
%! lines = asked ('tilt', 'rolling', struct ('name', 'fill', ...
%!                                           'canChange', 'no'));
%! assert (lines{1}, 'change    from the reference to moist');
%! assert (lines{2}, '          can have changed: tilt');
%! assert (! isempty (strfind (lines{3}, 'unlikely')));
%! assert (lines{4}, '          cannot have changed, left out: fill');
%! assert (lines{7}, '          Not said of: tilt, rolling');
%!assert (numel (asked (struct ('name', 'tilt', 'canChange', 'yes'))), 2)
%!assert (numel (asked ()), 1)

% SPDX-License-Identifier: GPL-3.0-only
