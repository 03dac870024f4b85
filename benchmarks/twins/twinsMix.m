% TWINSMIX  Which cases a twin study draws, and from which random numbers.
%
% CALL: MIX = twinsMix (KIND)
%
%   KIND  'all' or 'singles', see foreignTwins
%   MIX   struct: seed, classes (cellstr) and shares (of all cases; the last
%         class takes what is left), levels (struct: signal to noise of each
%         class in turn), cosines (of look-alikes in turn)
%
% Errors: DEcalioc:twinsMix:unknownName
%
% See also: twinsDraw

function mix = twinsMix (kind)
  seeds = struct ('all', 13007, 'singles', 20002);
  if ~isfield (seeds, kind)
    error ('DEcalioc:twinsMix:unknownName', ...
           'twinsMix: KIND must be all or singles, got ''%s''. Choose one.', kind);
  end
  mix = struct ('seed', seeds.(kind), 'shares', [0.35, 0.3, 0.12, 0.08], ...
                'classes', {{'null', 'single', 'pair', 'off', 'look'}}, ...
                'cosines', [0.5, 0.7, 0.85, 0.9, 0.95]);
  mix.levels = struct ('null', 0, 'single', 1:12, ...
                       'pair', [4, 4, 5, 6, 8, 3], ...
                       'off', [3, 5, 8, 12], 'look', [3, 5, 8, 12]);
  if strcmp (kind, 'singles')
    mix.classes = {'single'};
    mix.shares = [];
  end
end

%!assert (twinsMix ('singles').classes, {'single'})
%!assert (numel (twinsMix ('all').classes), 5)
%!error id=DEcalioc:twinsMix:unknownName twinsMix ('dark')

% SPDX-License-Identifier: GPL-3.0-only
