% TWINSMIX  Which cases a twin study draws, and from which random numbers.
%
% CALL: MIX = twinsMix (KIND)
%
%   KIND  'blind', 'develop' (twins); 'foreign blind', 'foreign develop', the
%         same with ' nulls' or ' pairs' behind (foreignTwins); 'curve'
%         (curveTwins)
%   MIX   struct: seed, classes (cellstr) and shares (of all cases; the last
%         class takes what is left), levels (struct: signal to noise of each
%         class in turn), cosines (of look-alikes in turn), step (of strengths),
%         isReachable (prefer effects that can reach the level), isPinned (where
%         none of them can: full strength; else any strength), pairsDiffer
%         (members of a pair at levels of their own)
%
% Errors: DEcalioc:twinsMix:unknownName
%
% See also: twinsDraw

function mix = twinsMix (kind)
  seeds = {'blind', 7001; 'develop', 8001; ...
           'foreign blind', 13004; 'foreign develop', 14001; ...
           'foreign blind nulls', 15001; 'foreign develop nulls', 16001; ...
           'foreign blind pairs', 18002; 'foreign develop pairs', 19001; ...
           'curve', 17001};
  at = strcmp (kind, seeds(:, 1));
  if ~any (at)
    error ('DEcalioc:twinsMix:unknownName', ...
           'twinsMix: there is no study ''%s''. Choose one of: %s.', kind, ...
           strjoin (seeds(:, 1)', ', '));
  end
  if any (strcmp (kind, {'blind', 'develop'}))
    mix = standInMix ();
  elseif strcmp (kind, 'curve')
    mix = foreignMix ({'null', 'single'}, 0.5);
    mix.isPinned = false;
  elseif any (strcmp (kind(max (1, end - 4):end), {'nulls', 'pairs'}))
    mix = foreignMix ({kind(end - 4:end - 1)}, []);
  else
    mix = foreignMix ({'null', 'single', 'pair', 'off', 'look'}, ...
                      [0.35, 0.3, 0.12, 0.08]);
  end
  mix.seed = seeds{at, 2};
end

function mix = standInMix ()
  mix.classes = {'null', 'single', 'pair', 'out'};
  mix.shares = [0.4, 0.35, 0.1];
  for k = 1:4
    mix.levels.(mix.classes{k}) = [1, 2, 3, 4, 6, 8];
  end
  mix.cosines = [];
  mix.step = 0.02;
  mix.isReachable = false;
  mix.isPinned = true;
  mix.pairsDiffer = false;
end

function mix = foreignMix (classes, shares)
  mix = struct ('classes', {classes}, 'shares', shares, 'step', 0.01, ...
                'cosines', [0.5, 0.7, 0.85, 0.9, 0.95], ...
                'isReachable', true, 'isPinned', true, 'pairsDiffer', true);
  mix.levels = struct ('null', 0, 'single', 1:12, ...
                       'pair', [4, 4, 5, 6, 8, 3], ...
                       'off', [3, 5, 8, 12], 'look', [3, 5, 8, 12]);
end

%!test % every study has random numbers of its own
%! kinds = {'blind', 'develop', 'foreign blind', 'foreign develop', ...
%!          'foreign blind nulls', 'foreign develop nulls', ...
%!          'foreign blind pairs', 'foreign develop pairs', 'curve'};
%! seeds = cellfun (@(kind) twinsMix (kind).seed, kinds);
%! assert (numel (unique (seeds)), numel (kinds));
%! assert (twinsMix ('foreign blind nulls').classes, {'null'});
%! assert (twinsMix ('foreign develop pairs').classes, {'pair'});
%! assert (numel (twinsMix ('foreign develop').classes), 5);
%!error id=DEcalioc:twinsMix:unknownName twinsMix ('dark')
