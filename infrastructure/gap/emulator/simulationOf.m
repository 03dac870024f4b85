% SIMULATIONOF  The emulator of the simulation, which that of a change holds.
%
% CALL: EM = simulationOf (EM)
%
%   EM  of takeReference, or of fitEmulator (then the same)

function em = simulationOf (em)
  if ~isempty (em.change)
    for name = fieldnames (em.change.plain)'
      em.(name{1}) = em.change.plain.(name{1});
    end
  end
  [em.change, em.known] = deal ([]);
end

%!test
%! em = struct ('coef', 3, 'known', 1, 'change', struct ('plain', ...
%!              struct ('coef', 2)));
%! em = simulationOf (em);
%! assert ({em.coef, em.known, em.change}, {2, [], []});
%! assert (simulationOf (em), em);
