% WITHOUTEFFECTS  Takes effects off the list of an emulator.
%
% CALL: EM = withoutEffects (EM, NUMBERS)
%
%   EM       struct of fitEmulator
%   NUMBERS  1 x m, effects to take off
%
% See also: calibrateVerdict

function em = withoutEffects (em, numbers)
  em.effect(numbers) = [];
end

%!test
%! em.effect = struct ('name', {'a', 'b', 'c'});
%! assert ({withoutEffects(em, 2).effect.name}, {'a', 'c'});
