% TWINSMIX  Which cases a twin study draws, and from which random numbers.
%
% CALL: MIX = twinsMix (KIND)
%
%   KIND  'foreign blind', 'foreign develop', or these with ' nulls', ' singles'
%         or ' pairs' behind, see foreignTwins
%   MIX   struct: seed, classes (cellstr) and shares (of all cases; the last
%         class takes what is left), levels (struct: signal to noise of each
%         class in turn), cosines (of look-alikes in turn)
%
% Errors: DEcalioc:twinsMix:unknownName
%
% See also: twinsDraw

function mix = twinsMix (kind)
  seeds = {'foreign blind', 13007; 'foreign develop', 14001; ...
           'foreign blind nulls', 15001; 'foreign develop nulls', 16001; ...
           'foreign blind singles', 20002; ...
           'foreign develop singles', 21001; ...
           'foreign blind pairs', 18002; 'foreign develop pairs', 19001};
  at = strcmp (kind, seeds(:, 1));
  if ~any (at)
    error ('DEcalioc:twinsMix:unknownName', ...
           'twinsMix: there is no study ''%s''. Choose one of: %s.', kind, ...
           strjoin (seeds(:, 1)', ', '));
  end
  mix = struct ('seed', seeds{at, 2}, 'shares', [0.35, 0.3, 0.12, 0.08], ...
                'classes', {{'null', 'single', 'pair', 'off', 'look'}}, ...
                'cosines', [0.5, 0.7, 0.85, 0.9, 0.95]);
  mix.levels = struct ('null', 0, 'single', 1:12, ...
                       'pair', [4, 4, 5, 6, 8, 3], ...
                       'off', [3, 5, 8, 12], 'look', [3, 5, 8, 12]);
  only = regexp (kind, '(null|single|pair)s$', 'tokens', 'once');
  if ~isempty (only)
    mix.classes = only;
    mix.shares = [];
  end
end

%!test % every study has random numbers of its own
%! kinds = {'foreign blind', 'foreign develop', 'foreign blind nulls', ...
%!          'foreign develop nulls', 'foreign blind singles', ...
%!          'foreign develop singles', 'foreign blind pairs', ...
%!          'foreign develop pairs'};
%! seeds = cellfun (@(kind) twinsMix (kind).seed, kinds);
%! assert (numel (unique (seeds)), numel (kinds));
%! assert (twinsMix ('foreign blind nulls').classes, {'null'});
%! assert (twinsMix ('foreign blind singles').classes, {'single'});
%! assert (twinsMix ('foreign develop pairs').classes, {'pair'});
%! assert (numel (twinsMix ('foreign develop').classes), 5);
%!error id=DEcalioc:twinsMix:unknownName twinsMix ('dark')
