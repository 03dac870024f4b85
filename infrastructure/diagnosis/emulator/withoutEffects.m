% WITHOUTEFFECTS  Takes effects off the list of an emulator.
%
% CALL: EMULATOR = withoutEffects (EMULATOR, NUMBERS)
%
%   EMULATOR  struct of fitEmulator
%   NUMBERS  1 x m, effects to take off (default: all); pairs with one of them
%            go too, the members of the others are numbered anew

function emulator = withoutEffects (emulator, numbers)
  if nargin < 2
    numbers = 1:numel (emulator.effect);
  end
  new = zeros (1, numel (emulator.effect));
  new(setdiff (1:numel (new), numbers)) = 1:numel (new) - numel (numbers);
  emulator.effect(numbers) = [];
  kept = false (1, numel (emulator.joint));
  for j = 1:numel (emulator.joint)
    emulator.joint(j).members = new(emulator.joint(j).members);
    kept(j) = all (emulator.joint(j).members > 0);
  end
  emulator.joint = emulator.joint(kept);
end

%!test
%! emulator.effect = struct ('name', {'a', 'b', 'c'});
%! emulator.joint = struct ('members', {[1, 2], [1, 3], [2, 3]});
%! left = withoutEffects (emulator, 2);
%! assert ({left.effect.name}, {'a', 'c'});
%! assert ({left.joint.members}, {[1, 2]});
%! assert (isempty (withoutEffects (emulator).effect));

% SPDX-License-Identifier: GPL-3.0-only
