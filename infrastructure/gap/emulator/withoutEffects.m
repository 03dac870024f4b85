% WITHOUTEFFECTS  Takes effects off the list of an emulator.
%
% CALL: EM = withoutEffects (EM, NUMBERS)
%
%   EM       struct of fitEmulator
%   NUMBERS  1 x m, effects to take off (default: all); pairs with one of them
%            go too, the members of the others are numbered anew

function em = withoutEffects (em, numbers)
  if nargin < 2
    numbers = 1:numel (em.effect);
  end
  new = zeros (1, numel (em.effect));
  new(setdiff (1:numel (new), numbers)) = 1:numel (new) - numel (numbers);
  em.effect(numbers) = [];
  kept = false (1, numel (em.joint));
  for j = 1:numel (em.joint)
    em.joint(j).members = new(em.joint(j).members);
    kept(j) = all (em.joint(j).members > 0);
  end
  em.joint = em.joint(kept);
end

%!test
%! em.effect = struct ('name', {'a', 'b', 'c'});
%! em.joint = struct ('members', {[1, 2], [1, 3], [2, 3]});
%! left = withoutEffects (em, 2);
%! assert ({left.effect.name}, {'a', 'c'});
%! assert ({left.joint.members}, {[1, 2]});
%! assert (isempty (withoutEffects (em).effect));
