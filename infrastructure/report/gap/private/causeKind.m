% CAUSEKIND  What kind of cause an effect is, where its name says too much.
%
% CALL: KIND = causeKind (EFFECT)
%
%   EFFECT  scalar struct name, group, laboratory (describeEffect)
%   KIND    'holds' (what holds grains together), 'slows' (what slows them),
%           'amount' (how much there is of them, and how large they are), 'measured'
%           (how it was measured: the rig, its setting, its instruments); '': of the
%           user's own, and no group of the library
%
% Words: kind.* in words.txt.

function kind = causeKind (effect)
  kinds = {'holds', {'adhesion'}; ...
           'slows', {'friction', 'grain shape', 'wall', 'restitution', 'drag', ...
                     'stiffness', 'vibration', 'buoyancy'}; ...
           'amount', {'size', 'mass', 'fill'}; ...
           'measured', {'alignment', 'gauge', 'clock', 'load', 'speed', 'gravity', ...
                        'opening', 'blockedExit', 'liftSpeed'}};
  isIt = cellfun (@(groups) any (strcmp (effect.group, groups)), kinds(:, 2));
  kind = '';
  if effect.laboratory
    kind = 'measured';                 % also an error of a balance, of group mass
  elseif any (isIt)
    kind = kinds{isIt, 1};
  end
end

%!test
%! % each effect of the library is of a kind
%! for name = listEffects ()
%!   assert (! isempty (causeKind (getEffect (name{1}))), name{1});
%! end
%! assert (causeKind (getEffect ('pullOff')), 'holds');
%! assert (causeKind (getEffect ('gain')), 'measured');
%! assert (causeKind (struct ('name', 'own', 'group', 'own', 'laboratory', false)), '');

% SPDX-License-Identifier: GPL-3.0-only
