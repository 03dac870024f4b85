% EFFECTVARIANCE  Variance of what an effect adds, from its surrogate.
%
% CALL: V = effectVariance (E, B, PSI)
%
%   E    struct of learnEffect
%   B    n x q, its monomials (polyRows of E.powers)
%   PSI  n x 1, bent strengths
%   V    n x T

function V = effectVariance (e, B, psi)
  % B holds psi in every term, so both parts vanish at neutral and the null model
  % stays nested
  V = (B * e.root).^2 * e.ofTarget + psi.^2 .* e.misfit;
end

%!test
%! e = struct ('root', [1; 2], 'ofTarget', [1, 0], 'misfit', [3, 1]);
%! assert (effectVariance (e, [1, 1; 0, 1], [0; 2]), [9, 0; 16, 4]);

% SPDX-License-Identifier: GPL-3.0-only
