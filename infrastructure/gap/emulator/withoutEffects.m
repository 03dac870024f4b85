% WITHOUTEFFECTS  Takes effects off the list of an emulator.
%
% CALL: EM = withoutEffects (EM, NUMBERS)
%
%   EM       struct of fitEmulator
%   NUMBERS  1 x m, effects to take off (default: all)
%
% See also: calibrateVerdict

function em = withoutEffects (em, numbers)
  if nargin < 2
    numbers = 1:numel (em.effect);
  end
  em.effect(numbers) = [];
end

%!test
%! em.effect = struct ('name', {'a', 'b', 'c'});
%! assert ({withoutEffects(em, 2).effect.name}, {'a', 'c'});
%! assert (isempty (withoutEffects (em).effect));
