% SLOTRATE  Mass flow through a slot, a metre long, with a cohesive arch.
%
% CALL: W = slotRate (WIDTH, GRAIN, DENSITY, STRENGTH, LAW)
%
%   WIDTH     1 x m, of the slot (m)
%   GRAIN     n x 1, diameter of a grain (m)
%   DENSITY   n x 1, bulk density (kg/m3)
%   STRENGTH  n x 1, unconfined strength of the material (Pa)
%   LAW       struct C (about 1), k (about 1.4): scalars or n x 1
%   W         n x m (kg/s), 0 where an arch or k grains close the slot
%
% W = C rho sqrt (g) (B - k d - B0)^1.5, with B0 = STRENGTH / (rho g): the slot
% that an arch of this strength can span (Jenike 1964).
%
% See also: dischargeRate, foreignLab

function W = slotRate (width, grain, density, strength, law)
  arch = strength ./ (density * 9.81);
  free = max (0, width - law.k .* grain - arch);
  W = law.C .* density .* sqrt (9.81) .* free.^1.5;
end

%!test % closed by k grains or by an arch of 15 mm, else 3/2 power
%! law = struct ('C', 1, 'k', 1.4);
%! W = slotRate ([0.002, 0.03], 0.002, 1500, 0, law);
%! assert (W, [0, 1500 * sqrt(9.81) * 0.0272^1.5], 1e-9);
%! strong = 1500 * 9.81 * 0.015;
%! W = slotRate ([0.0178, 0.0179], 0.002, 1500, strong, law);
%! assert (W(1), 0, 1e-6);
%! assert (W(2) > 1e-4);
