% GATETEST  Tests whether there is a gap, with weak listed effects in mind.
%
% CALL: GATE = gateTest (MODELS, SCREEN, NULL, I)
%
%   MODELS  struct of makeModels
%   SCREEN  struct of screenEffects at the null fit
%   NULL    null fit of fitLibrary;  I its row
%   GATE    struct
%     chi2, df, pFit   lack of fit of the null model
%     top, pTop        largest drop of chi2 by one listed effect, its p-value
%     p                of the smaller of the two, corrected for taking it
%
% With as many parameters as targets only the limits of the parameters can be
% tested: what they keep out of reach counts, with one degree of freedom.
%
% The drop along a known direction has one degree of freedom and sees effects
% that the whole chi2 does not. Reference: 1000 draws of rho ~ N (0, I).
%
% See also: lackOfFit, weighCase

function gate = gateTest (models, screen, null, i)
  rho = screen.parity.rho;
  n = numel (rho);
  gate.chi2 = null.chi2(i);
  gate.df = max (n, 1);
  gate.top = max ([screen.gain, 0]);
  if n == 0
    gate.pFit = chiSquareTail (gate.chi2, 1);
    gate.pTop = 1;
    gate.p = gate.pFit;
    return
  end
  draws = models.noise(:, 1:n);
  along = draws * screen.directions;
  negative = logical (screen.sided) & along < 0;
  along(negative) = 0;
  top = max ([along.^2, zeros(rows (draws), 1)], [], 2);
  pFit = chiSquareTail (sum (draws.^2, 2), n);
  B = rows (draws);
  [~, order] = sort (-top);
  pTop = zeros (B, 1);
  pTop(order) = (1:B)' / B;
  gate.pFit = chiSquareTail (gate.chi2, gate.df);
  gate.pTop = (1 + sum (top >= gate.top)) / (B + 1);
  least = min (gate.pFit, gate.pTop);
  gate.p = (1 + sum (min (pFit, pTop) <= least)) / (B + 1);
end

%!test
%! models = handMadeModels ();
%! y = [1.5, 0.5, 0, 0; 1.5, 0.5, 2.6, 2.6];
%! fits = fitLibrary (models, y);
%! p = zeros (1, 2);
%! for i = 1:2
%!   screen = screenEffects (models.white, fits.null.Q(i, :), y(i, :));
%!   p(i) = gateTest (models, screen, fits.null, i).p;
%! end
%! assert (p(1) > 0.5);
%! assert (p(2) < 0.01);
%!test
%! % one target, one parameter: out of reach of the box, or within
%! models.noise = zeros (10, 1);
%! screen = struct ('gain', zeros (1, 0), 'sided', zeros (1, 0));
%! screen.parity.rho = zeros (0, 1);
%! gate = gateTest (models, screen, struct ('chi2', [100, 0.5]), 1);
%! assert (gate.p < 1e-6);
%! gate = gateTest (models, screen, struct ('chi2', [100, 0.5]), 2);
%! assert (gate.p > 0.4);
