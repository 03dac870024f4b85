% DISCHARGERATE  Mass flow through a round opening, with jamming (Beverloo).
%
% CALL: W = dischargeRate (OPENING, GRAIN, DENSITY, LAW)
%
%   OPENING  n x m, diameter that is left for the flow (m)
%   GRAIN    n x 1, diameter of a grain (m)
%   DENSITY  n x 1, bulk density (kg/m3)
%   LAW      struct of scalars or n x 1: C (about 0.58), k (about 1.4), jam
%            (openings in grains over which jamming fades, about 4)
%   W        n x m (kg/s), 0 where the opening is narrower than k grains
%
% W = C rho sqrt (g) (1 - exp (-(D/d - k) / jam) / 2) (D - k d)^2.5: Beverloo et
% al. 1961; the factor for few grains across as Mankoc et al. 2007.
%
% See also: slotRate, foreignLab

function W = dischargeRate (opening, grain, density, law)
  free = max (0, opening - law.k .* grain);
  few = 1 - 0.5 * exp (-free ./ grain ./ law.jam);
  W = law.C .* density .* sqrt (9.81) .* few .* free.^2.5;
end

%!shared law
%! law = struct ('C', 0.58, 'k', 1.4, 'jam', 4);
%!test % nothing flows below k grains, above it more and more
%! W = dischargeRate ([2, 4.2, 4.3, 10, 20] / 1000, 0.003, 1500, law);
%! assert (W(1:2), [0, 0], 1e-12);
%! assert (W(3) > 0 && all (diff (W(2:5)) > 0));
%!test % wide openings: Beverloo's law
%! W = dischargeRate (0.2, 0.002, 1500, law);
%! assert (W, 0.58 * 1500 * sqrt (9.81) * 0.1972^2.5, 1e-6 * W);
%!test % coarser grains flow slower
%! W = dischargeRate ([1; 1] * 0.02, [0.002; 0.003], 1500, law);
%! assert (W(2) < W(1));
