% TWINSMARK  How alike the true mark of a twin is to that of listed effects.
%
% CALL: COSINE = twinsMark (TWIN, EFFECTS, LAB)
%
%   TWIN     element of twinsDraw;  LAB  element of foreignLaboratories
%   EFFECTS  1 x m, numbers of effects
%   COSINE   1 x m, largest cosine of the true mark with that of each effect at
%            a quarter, half and full strength (both ways where it acts so),
%            without what parameters absorb, in units of the noise
%
% The laws are asked, not the surrogates.

function cosine = twinsMark (twin, effects, lab)
  space = twinsSpace (lab, twin.theta);
  see = @(Z) (space.factor \ (Z - space.base)')' * space.free;
  mark = see (lab.means (twin.theta, twin.phi) + twin.alien);
  cosine = zeros (1, numel (effects));
  for i = 1:numel (effects)
    k = effects(i);
    strength = [1; 0.5; 0.25];
    strength = [strength; -strength(1:3 * lab.isSigned(k))];
    phi = strength * ((1:numel (lab.isSigned)) == k);
    own = see (lab.means (ones (rows (phi), 1) * twin.theta, phi));
    cosine(i) = max (own * mark' ./ max (norm (mark) * ...
                                         norm (own, 'rows'), realmin));
  end
end

%!test
%! % two effects of which one moves both targets, the other one the first alone;
%! % the one parameter moves a third target
%! lab = struct ('noise', [1, 1, 1], 'isSigned', [false, true]);
%! lab.means = @(theta, phi) phi * [3, 4, 0; 2, 0, 0] + theta * [0, 0, 1];
%! lab.problem.effects = [1, 1];
%! twin = struct ('theta', 0.5, 'phi', [1, 0], 'alien', [0, 0, 0]);
%! assert (twinsMark (twin, [1, 2], lab), [1, 0.6], 1e-9);
